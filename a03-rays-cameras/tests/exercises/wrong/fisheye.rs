//! Angles measured by the wrong side of the picture, or not bent at all.

use a02_math::Vector3;
use a03_rays_cameras::{Basis, Camera, Ray};
use common::Size;
use testing::exercise::{Check, Wrong};

use crate::fisheye::check;

/// A camera of a function of basis, opening, size, and place from the middle.
struct Own<F>(Basis, f64, F);

impl<F: Fn(&Basis, f64, Size, f64, f64) -> Ray + Send + Sync + 'static> Camera for Own<F> {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let Self(basis, angle, ray) = self;
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let (x, y) = (x - (width - 1.0) / 2.0, y - (height - 1.0) / 2.0);
        ray(basis, *angle, size, x, y)
    }
}

fn own(check_: &mut Check, ray: fn(&Basis, f64, Size, f64, f64) -> Ray) {
    check(check_, |basis, angle| Own(basis, angle, ray));
}

/// The ray at this angle from the gaze, towards the place (x, y) from the middle.
fn bent(basis: &Basis, x: f64, y: f64, angle: f64) -> Ray {
    let r = libm::hypot(x, y);
    let aside = if r == 0.0 {
        basis.u
    } else {
        basis.u * (x / r) + basis.v * (y / r)
    };
    let (sin, cos) = libm::sincos(angle);
    Ray::derived(basis.e, aside * sin - basis.w * cos)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "divided by 0 in the middle",
        says: "direction at (0.000, 0.000) heights from the middle of 101x101, opening 0.500, gaze [0.0, 0.0, -1.0]: expected (0, 0, -1), got (NaN",
        check: |c| {
            own(c, |b, angle, size, x, y| {
                let r = libm::hypot(x, y);
                let (sin, cos) = libm::sincos(r / f64::from(size.height()) * angle);
                Ray::derived(b.e, (b.u * (x / r) + b.v * (y / r)) * sin - b.w * cos)
            });
        },
    },
    Wrong {
        mistake: "the width instead of the height",
        says: "heights from the middle of 161x121, opening 0.500",
        check: |c| {
            own(c, |b, angle, size, x, y| {
                bent(b, x, y, libm::hypot(x, y) / f64::from(size.width()) * angle)
            });
        },
    },
    Wrong {
        mistake: "half the opening at the height's distance",
        says: "direction at (0.500, 0.000) heights from the middle of 101x101, opening 0.500",
        check: |c| {
            own(c, |b, angle, size, x, y| {
                bent(
                    b,
                    x,
                    y,
                    libm::hypot(x, y) / f64::from(size.height()) * angle / 2.0,
                )
            });
        },
    },
    Wrong {
        mistake: "the tangent, as in a camera with a flat picture",
        says: "heights from the middle of 101x101, opening",
        check: |c| {
            own(c, |b, angle, size, x, y| {
                let r = libm::hypot(x, y) / f64::from(size.height());
                bent(
                    b,
                    x,
                    y,
                    libm::atan2(2.0 * r * libm::sin(angle / 2.0), libm::cos(angle / 2.0)),
                )
            });
        },
    },
    Wrong {
        mistake: "both angles by themselves",
        says: "direction at (-0.300, 0.400) heights from the middle of 101x101, opening 0.500",
        check: |c| {
            own(c, |b, angle, size, x, y| {
                let h = f64::from(size.height());
                let (around, up) = (x / h * angle, y / h * angle);
                let level = b.u * libm::sin(around) - b.w * libm::cos(around);
                Ray::derived(b.e, level * libm::cos(up) + b.v * libm::sin(up))
            });
        },
    },
    Wrong {
        mistake: "up and down exchanged",
        says: "direction at (0.000, 0.500) heights from the middle of 101x101",
        check: |c| {
            own(c, |b, angle, size, x, y| {
                bent(
                    b,
                    x,
                    -y,
                    libm::hypot(x, y) / f64::from(size.height()) * angle,
                )
            });
        },
    },
    Wrong {
        mistake: "along w, which points back",
        says: "gaze [0.0, 0.0, -1.0]: expected (0, 0, -1), got (0, -0, 1)",
        check: |c| {
            own(c, |b, angle, size, x, y| {
                let turned = Basis { w: -b.w, ..*b };
                bent(
                    &turned,
                    x,
                    y,
                    libm::hypot(x, y) / f64::from(size.height()) * angle,
                )
            });
        },
    },
    Wrong {
        mistake: "the axes of the world instead of the camera's",
        says: "gaze [1.0, 2.0, -2.0]: expected",
        check: |c| {
            own(c, |b, angle, size, x, y| {
                let [u, v, w] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
                    .map(|xyz| Vector3::from_glam(xyz.into()));
                let world = Basis { e: b.e, u, v, w };
                bent(
                    &world,
                    x,
                    y,
                    libm::hypot(x, y) / f64::from(size.height()) * angle,
                )
            });
        },
    },
];
