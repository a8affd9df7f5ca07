//! Fisheyes anywhere, compared with the solution.

use std::f64::consts::{FRAC_PI_6, PI};

use crate::camera::compare;
use crate::prelude::*;
use crate::solutions::fisheye::Fisheye;

fn basis(e: [f64; 3], gaze: [f64; 3]) -> Result<Basis, ArgumentError> {
    Basis::new(point(e), vector(gaze), vector([0.0, 1.0, 0.0]))
}

pub fn check<C: Camera>(check: &mut Check, new: impl Fn(Basis, f64) -> C) {
    compare(
        check,
        "eye {}, gaze {}, opening {}",
        ([0.0; 3], [0.0, 0.0, -1.0], PI),
        |r| (r.triple(9.0), r.triple(3.0), r.between(0.5, 6.0)),
        |(e, gaze, angle)| Ok(Fisheye::new(basis(e, gaze)?, angle)),
        |(e, gaze, angle)| Ok(new(basis(e, gaze)?, angle)),
    );
    // A globe of meridians and parallels, seen from inside.
    check.picture(|settings| {
        let camera = new(basis([1.0, 2.0, 3.0], [0.0, 0.3, -1.0])?, PI);
        let paint = |ray: &Ray| {
            let d = ray.direction();
            let up = libm::atan2(d.y(), (d.x() * d.x() + d.z() * d.z()).sqrt());
            let around = libm::atan2(d.x(), -d.z());
            let fields = (up / FRAC_PI_6).floor() + (around / FRAC_PI_6).floor();
            let light = 0.4 + 0.6 * fields.rem_euclid(2.0);
            let is_below = d.y() < 0.0;
            (if is_below {
                Color::new(0.3, 0.8, 0.3)
            } else {
                Color::new(0.4, 0.6, 1.0)
            }) * light
        };
        render(&camera, paint, settings, &())
    });
}

/// A fisheye with other angles from the gaze, from the place from the middle in heights, the
/// aspect ratio and the opening.
struct Own(Basis, f64, fn([f64; 2], f64, f64) -> f64);

impl Camera for Own {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        let [width, height] = [size.width(), size.height()].map(f64::from);
        let place = [x - (width - 1.0) / 2.0, y - (height - 1.0) / 2.0].map(|p| p / height);
        let Basis { e, u, v, w } = self.0;
        let around = libm::atan2(place[1], place[0]);
        let (sin, cos) = libm::sincos((self.2)(place, width / height, self.1));
        let aside = u * libm::cos(around) + v * libm::sin(around);
        Ray::derived(e, aside * sin - w * cos)
    }
}

pub const VARIANTS: &[Variant] = &[
    wrong(
        "the opening is the angle over the height, not over the width",
        |c| {
            check(c, |basis, angle| {
                Own(basis, angle, |[x, y], a, angle| {
                    libm::hypot(x, y) / a * angle
                })
            });
        },
    ),
    wrong("the distance is the angle, not its tangent", |c| {
        check(c, |basis, angle| {
            Own(basis, angle, |[x, y], _, angle| {
                libm::atan(2.0 * libm::hypot(x, y) * libm::tan(angle / 2.0))
            })
        });
    }),
];
