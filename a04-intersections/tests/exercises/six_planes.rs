//! Boxes of six planes anywhere, compared with the solution.

use crate::prelude::*;
use crate::solutions::six_planes::SixPlanes;

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Point3) -> Result<G, ArgumentError>,
) {
    compare_boxes(check, SixPlanes::new, &new);
    let shape = new(point([-0.3, 0.1, -0.7]), point([0.4, 1.2, 0.6]));
    show(check, shape, [2.0, 2.2, 2.9], [0.05, 0.6, 0.0]);
}

/// Hits of planes: those between the corners up to `beside`, along all axes or not their own,
/// and the nearest or the last.
fn variant(c: &mut Check, beside: f64, all_axes: bool, is_nearest: bool) {
    check(c, move |lbf, run| {
        own(move |ray: &Ray, within| {
            let faces = (0..3).flat_map(|axis| [(axis, lbf, -1.0), (axis, run, 1.0)]);
            let hits = faces.filter_map(|(own_axis, corner, side)| {
                let mut normal = [0.0; 3];
                normal[own_axis] = side;
                let hit = Plane::new(corner, vector(normal).as_normal())
                    .ok()?
                    .hit(ray, within)?;
                let [p, lbf, run] = [ray.at(hit.t), lbf, run].map(Point3::to_glam);
                let outside = (lbf - p).max(p - run).to_array();
                let mut axes = outside.into_iter().enumerate();
                let is_on = |(axis, outside)| (!all_axes && axis == own_axis) || outside <= beside;
                axes.all(is_on).then_some(hit)
            });
            hits.reduce(|old, new| {
                if is_nearest && old.t <= new.t {
                    old
                } else {
                    new
                }
            })
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("rounding puts a hit beside its own plane", |c| {
        variant(c, 0.0, true, true)
    }),
    wrong("the nearest plane counts, not the last", |c| {
        variant(c, 0.0, false, false)
    }),
    wrong("with an epsilon, faces stick out", |c| {
        variant(c, 1e-4, true, true)
    }),
];
