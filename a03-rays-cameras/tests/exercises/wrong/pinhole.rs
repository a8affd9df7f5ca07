//! Wrong solutions.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Camera, Ray};
use common::Size;
use testing::exercise::{Check, Wrong};

use crate::pinhole;

struct Pinhole {
    origin: Point3,
    alpha: f64,
    /// From the place and the size of the picture and the opening angle.
    direction: fn([f64; 2], [f64; 2], f64) -> Vector3,
}

impl Camera for Pinhole {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let size = [size.width(), size.height()].map(f64::from);
        Ray::derived(self.origin, (self.direction)([x, y], size, self.alpha))
    }
}

fn check(check: &mut Check, direction: fn([f64; 2], [f64; 2], f64) -> Vector3) {
    pinhole::check(check, |origin, alpha| {
        Ok(Pinhole {
            origin,
            alpha,
            direction,
        })
    });
}

fn unit(x: f64, y: f64, z: f64) -> Vector3 {
    Vector3::new(x, y, z).normalized().unwrap_or_default()
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the whole angle instead of half of it",
        says: "at the upper edge",
        check: |c| {
            check(c, |[x, y], [w, h], alpha| {
                unit(
                    x - (w - 1.0) / 2.0,
                    y - (h - 1.0) / 2.0,
                    -h / 2.0 / libm::tan(alpha),
                )
            });
        },
    },
    Wrong {
        mistake: "the corner of the pixel instead of its middle",
        says: "through the middle",
        check: |c| {
            check(c, |[x, y], [w, h], alpha| {
                unit(x - w / 2.0, y - h / 2.0, -h / 2.0 / libm::tan(alpha / 2.0))
            });
        },
    },
    Wrong {
        mistake: "upside down",
        says: "at the upper edge",
        check: |c| {
            check(c, |[x, y], [w, h], alpha| {
                unit(
                    x - (w - 1.0) / 2.0,
                    (h - 1.0) / 2.0 - y,
                    -h / 2.0 / libm::tan(alpha / 2.0),
                )
            });
        },
    },
    Wrong {
        mistake: "not of length 1",
        says: "through the middle",
        check: |c| {
            check(c, |[x, y], [w, h], alpha| {
                let z = -h / 2.0 / libm::tan(alpha / 2.0);
                Vector3::new(x - (w - 1.0) / 2.0, y - (h - 1.0) / 2.0, z)
            });
        },
    },
    Wrong {
        mistake: "the opening of the width",
        says: "at the upper edge",
        check: |c| {
            check(c, |[x, y], [w, h], alpha| {
                unit(
                    x - (w - 1.0) / 2.0,
                    y - (h - 1.0) / 2.0,
                    -w / 2.0 / libm::tan(alpha / 2.0),
                )
            });
        },
    },
];
