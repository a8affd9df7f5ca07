//! Boxes of six planes anywhere, compared with the solution.

use crate::prelude::*;

#[path = "../../exercises/solutions/six_planes.rs"]
mod solution;
pub use solution::SixPlanes;

pub fn check(check: &mut Check, new: &dyn Fn(Point3, Point3) -> Made<Shape>) {
    compare_boxes(check, &|lbf, run| boxed(SixPlanes::new(lbf, run)), new);
    let shape = new(point([-0.3, 0.1, -0.7]), point([0.4, 1.2, 0.6]));
    show(check, shape, [2.0, 2.2, 2.9], [0.05, 0.6, 0.0]);
}

variants! { variant:
    yours => &|lbf, run| shape::boxed(SixPlanes::new(lbf, run));
    wrong "rounding puts a hit beside its own plane" => |_, hit, ray, _, corners| {
        let [p, lbf, run] = [ray.at(hit.t), corners[0], corners[1]].map(Point3::to_glam);
        Some(hit).filter(|_| lbf.min(p) == lbf && run.max(p) == run)
    };
    wrong "the nearest plane counts, not the last" => |planes, hit, ray, i, _| {
        planes.hit(ray, Interval { min: hit.t, ..i }).or(Some(hit))
    };
}

/// The solution with another choice of its hit.
fn variant(c: &mut Check, choose: fn(&SixPlanes, Hit, &Ray, Interval, [Point3; 2]) -> Option<Hit>) {
    check(c, &move |lbf, run| {
        let planes = SixPlanes::new(lbf, run)?;
        own(move |ray: &Ray, i| choose(&planes, planes.hit(ray, i)?, ray, i, [lbf, run]))
    });
}
