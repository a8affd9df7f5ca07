//! Rays that are sharp on a ball, nowhere, or through another lens.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::{Basis, Ray};
use testing::exercise::Wrong;

use crate::solutions::thin_lens::through_lens;
use crate::thin_lens::check;

/// The ray from a place of the lens to the sharp point.
fn joined(basis: &Basis, origin: Point3, sharp: Point3) -> Ray {
    let direction = (sharp - origin).normalized();
    Ray::derived(origin, direction.unwrap_or(-basis.w))
}

fn on_lens(basis: &Basis, (right, up): (f64, f64)) -> Point3 {
    basis.e + basis.u * right + basis.v * up
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "sharp at the distance of focus from the eye, on a ball",
        says: "where the ray meets the sharp point, lens (0.1, 0), focus 0.5, sharp point [1.250, 2.000, 2.500]",
        check: |c| {
            check(c, |basis, focus, ray, lens| {
                joined(basis, on_lens(basis, lens), ray.at(focus))
            });
        },
    },
    Wrong {
        mistake: "the old direction from a new place",
        says: "where the ray meets the sharp point, lens (0.1, 0), focus 0.5",
        check: |c| {
            check(c, |basis, _, ray, lens| {
                Ray::derived(on_lens(basis, lens), ray.direction())
            });
        },
    },
    Wrong {
        mistake: "a new direction from the eye",
        says: "origin, lens (0.1, 0), focus 0.5, sharp point [1.000, 2.000, 2.500], gaze [0.000, 0.000, -1.000]: expected (1.1, 2, 3), got (1, 2, 3)",
        check: |c| {
            check(c, |basis, focus, ray, lens| {
                let new = through_lens(basis, focus, ray, lens);
                Ray::derived(basis.e, new.direction())
            });
        },
    },
    Wrong {
        mistake: "a direction that is not made unit",
        says: "length of the direction, lens (0, 0), focus 0.5, sharp point [1.000, 2.000, 2.500], gaze [0.000, 0.000, -1.000]: expected 1, got 0.5",
        check: |c| {
            check(c, |basis, focus, ray, lens| {
                let origin = on_lens(basis, lens);
                let along = -basis.w.dot(ray.direction());
                Ray::derived(origin, ray.at(focus / along) - origin)
            });
        },
    },
    Wrong {
        mistake: "a lens along the axes of the world",
        says: "origin, lens (0.1, 0), focus 0.5, sharp point [1.167, 2.333, 2.667], gaze [0.333, 0.667, -0.667]",
        check: |c| {
            check(c, |basis, focus, ray, (right, up)| {
                let sharp = ray.at(focus / -basis.w.dot(ray.direction()));
                joined(basis, basis.e + Vector3::new(right, up, 0.0), sharp)
            });
        },
    },
    Wrong {
        mistake: "the sharp point behind the eye",
        says: "where the ray meets the sharp point, lens (0, 0), focus 0.5",
        check: |c| {
            check(c, |basis, focus, ray, lens| {
                through_lens(basis, -focus, ray, lens)
            });
        },
    },
    Wrong {
        mistake: "multiplied with the cosine instead of divided",
        says: "where the ray meets the sharp point, lens (0.1, 0), focus 0.5, sharp point [1.250, 2.000, 2.500]",
        check: |c| {
            check(c, |basis, focus, ray, lens| {
                let along = -basis.w.dot(ray.direction());
                joined(basis, on_lens(basis, lens), ray.at(focus * along))
            });
        },
    },
];
