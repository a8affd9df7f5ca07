//! Wrong solutions.

use a02_math::Vector3;
use a03_rays_cameras::{Basis, Camera, Ray};
use common::Size;
use testing::exercise::{Check, Wrong};

use crate::orthographic;

/// A camera whose rays follow from axes, scale, place and size of the picture.
struct Orthographic(Basis, f64, Rays);

type Rays = fn(Basis, f64, [f64; 2], [f64; 2]) -> Ray;

impl Camera for Orthographic {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let size = [size.width(), size.height()].map(f64::from);
        (self.2)(self.0, self.1, [x, y], size)
    }
}

fn check(check: &mut Check, rays: Rays) {
    orthographic::check(check, |e, g, t, s| {
        Ok(Orthographic(Basis::new(e, g, t)?, s, rays))
    });
}

fn from(basis: Basis, right: f64, up: f64) -> Ray {
    Ray::derived(basis.e + basis.u * right + basis.v * up, -basis.w)
}

/// Offset of a pixel from the middle, as a share of the whole.
fn share(p: f64, n: f64) -> f64 {
    (p - (n - 1.0) / 2.0) / (n - 1.0)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the aspect ratio is left out",
        says: "the origin through the middle of the last column",
        check: |c| {
            check(c, |basis, s, [x, y], [w, h]| {
                from(basis, s * share(x, w), s * share(y, h))
            });
        },
    },
    Wrong {
        mistake: "the scale is that of the width",
        says: "the origin through the middle of the lowest row",
        check: |c| {
            check(c, |basis, s, [x, y], [w, h]| {
                from(basis, s * share(x, w), s * h / w * share(y, h))
            });
        },
    },
    Wrong {
        mistake: "rays that start in one point",
        says: "the direction",
        check: |c| {
            check(c, |basis, s, [x, y], [w, h]| {
                let ray = from(basis, s * w / h * share(x, w), s * share(y, h));
                let direction: Vector3 = ray.origin() - basis.e - basis.w;
                Ray::derived(basis.e, direction)
            });
        },
    },
    Wrong {
        mistake: "along w, against the gaze",
        says: "the direction",
        check: |c| {
            check(c, |basis, s, [x, y], [w, h]| {
                let ray = from(basis, s * w / h * share(x, w), s * share(y, h));
                Ray::derived(ray.origin(), basis.w)
            });
        },
    },
    Wrong {
        mistake: "divided by the number of pixels, not by that of the steps between them",
        says: "the origin through the middle of the lowest row",
        check: |c| {
            check(c, |basis, s, [x, y], [w, h]| {
                let share = |p: f64, n: f64| (p - (n - 1.0) / 2.0) / n;
                from(basis, s * w / h * share(x, w), s * share(y, h))
            });
        },
    },
];
