//! Wrong solutions: other offsets.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use testing::exercise::{Check, Wrong};

use crate::leaving;

/// The ray whose origin is offset by this step.
fn check(check: &mut Check, step: fn(&Ray, &Hit, Vector3) -> Vector3) {
    leaving::check(check, |ray, hit, d| {
        Ray::derived(ray.at(hit.t) + step(ray, hit, d), d)
    });
}

fn size(ray: &Ray, hit: &Hit) -> f64 {
    let at = ray.at(hit.t).largest_coordinate();
    at.max(ray.origin().largest_coordinate()).max(hit.t)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "no offset",
        says: "offset to the side of the direction",
        check: |c| check(c, |_, _, _| Vector3::default()),
    },
    Wrong {
        mistake: "a fixed length",
        says: "the offset, as a share of the scene's size; scene of size 1e0",
        check: |c| {
            check(c, |_, hit, d| {
                Vector3::from(hit.face) * 1e-4_f64.copysign(hit.face.dot(d))
            });
        },
    },
    Wrong {
        mistake: "a tiny fixed length, less than the rounding error of a large scene",
        says: "scene of size 1e3",
        check: |c| {
            check(c, |_, hit, d| {
                Vector3::from(hit.face) * 1e-15_f64.copysign(hit.face.dot(d))
            });
        },
    },
    Wrong {
        mistake: "always outwards",
        says: "offset to the side of the direction, steep, inwards",
        check: |c| {
            check(c, |ray, hit, _| {
                Vector3::from(hit.face) * (1e-13 * size(ray, hit))
            });
        },
    },
    Wrong {
        mistake: "always inwards",
        says: "offset to the side of the direction, steep, outwards",
        check: |c| {
            check(c, |ray, hit, _| {
                Vector3::from(hit.face) * (-1e-13 * size(ray, hit))
            });
        },
    },
];
