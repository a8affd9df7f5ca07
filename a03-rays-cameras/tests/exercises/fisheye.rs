//! Fisheyes anywhere, compared with the solution.

use std::f64::consts::{FRAC_PI_6, PI};

use crate::camera::{Own, compare};
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
            let [green, blue] = [Color::new(0.3, 0.8, 0.3), Color::new(0.4, 0.6, 1.0)];
            (if d.y() < 0.0 { green } else { blue }) * light
        };
        render(&camera, paint, settings, &())
    });
}

/// A fisheye with other angles from the gaze, by the place from the middle, width and height,
/// and the opening.
fn variant(c: &mut Check, angle: fn(f64, [f64; 2], f64) -> f64) {
    check(c, move |Basis { e, u, v, w }, opening| {
        Own(move |[width, height]: [f64; 2], [x, y]: [f64; 2]| {
            let [x, y] = [x - (width - 1.0) / 2.0, y - (height - 1.0) / 2.0];
            let r = libm::hypot(x, y).max(f64::MIN_POSITIVE);
            let (sin, cos) = libm::sincos(angle(r, [width, height], opening));
            Ray::derived(e, (u * (x / r) + v * (y / r)) * sin - w * cos)
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("the opening is that of the height", |c| {
        variant(c, |r, [w, _], angle| r / w * angle)
    }),
    wrong("the distance is the angle, not its tangent", |c| {
        variant(c, |r, [_, h], angle| {
            libm::atan(2.0 * r / h * libm::tan(angle / 2.0))
        });
    }),
];
