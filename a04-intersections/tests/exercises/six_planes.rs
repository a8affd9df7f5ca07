//! Rays aimed at points of all six faces, from outside and from inside.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Interval};
use common::ArgumentError;
use testing::exercise::Check;

use crate::shape::{expect_hit, show};

/// Some roundings of coordinates up to 4.
const BOUND: f64 = 1e-13;

pub fn check<G: Geometry + 'static>(
    check: &mut Check,
    new: impl Fn(Point3, Point3) -> Result<G, ArgumentError>,
) {
    // No number of these is exact in binary.
    let (lbf, run) = ([-0.3, 0.1, -0.7], [0.4, 1.2, 0.6]);
    let point = |xyz: [f64; 3]| Point3::from_glam(xyz.into());
    let Ok(shape) = new(point(lbf), point(run)) else {
        return;
    };
    let hit = |ray: &Ray| shape.hit(ray, Interval::AHEAD);

    for axis in 0..3 {
        for (corner, side) in [(lbf, -1.0), (run, 1.0)] {
            let mut normal = [0.0; 3];
            normal[axis] = side;
            let normal = Normal3::from_glam(normal.into());
            for (i, j) in (1..10).flat_map(|i| (1..10).map(move |j| (i, j))) {
                // Between both corners along the two other axes.
                let mut at = corner;
                for (other, share) in [((axis + 1) % 3, i), ((axis + 2) % 3, j)] {
                    at[other] +=
                        (lbf[other] + run[other] - 2.0 * corner[other]) * (f64::from(share) / 10.0);
                }
                let at = point(at);
                let outside = point([0.11, 0.62, -0.07]) + Vector3::from(normal) * 3.1;
                let inside = point([0.07, 0.53, 0.09]);
                for (from, place) in [(outside, "from outside"), (inside, "from inside")] {
                    // One step of this ray leads to the face.
                    let ray = Ray::derived(from, at - from);
                    let what = format!("{place}, from {} to {}", from.to_glam(), at.to_glam());
                    expect_hit(check, &what, Some((1.0, normal)), BOUND, hit(&ray));
                }
            }
        }
    }

    let ahead = Vector3::new(0.0, 0.0, -1.0);
    for (from, place) in [
        ([0.41, 0.5, 3.0], "right of the box"),
        ([0.0, 0.09, 3.0], "below the box"),
        ([0.0, 0.5, -0.8], "away from the box"),
    ] {
        let ray = Ray::derived(point(from), ahead);
        expect_hit(check, place, None, BOUND, hit(&ray));
    }

    show(
        check,
        shape,
        Point3::new(2.0, 2.2, 2.9),
        Point3::new(0.05, 0.6, 0.0),
    );
}
