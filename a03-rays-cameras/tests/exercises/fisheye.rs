//! Fisheyes anywhere, compared with the solution.

use crate::prelude::*;

fn basis(e: [f64; 3], gaze: [f64; 3]) -> Made<Basis> {
    Basis::new(point(e), vector(gaze), vector([0.0, 1.0, 0.0]))
}

pub fn check<C: Camera>(check: &mut Check, new: impl Fn(Basis, f64) -> Made<C>) {
    compare(
        check,
        "eye {}, gaze {}, opening {}",
        ([0.0; 3], [0.0, 0.0, -1.0], PI),
        |r| (r.triple(9.0), r.triple(3.0), r.between(0.5, 6.0)),
        |(e, gaze, angle)| Ok(Fisheye::new(basis(e, gaze)?, angle)),
        |(e, gaze, angle)| new(basis(e, gaze)?, angle),
    );
    // A globe of meridians and parallels, seen from inside.
    check.picture(|settings| {
        let camera = new(basis([1.0, 2.0, 3.0], [0.0, 0.3, -1.0])?, PI)?;
        let paint = |ray: &Ray| {
            let d = ray.direction();
            let up = libm::atan2(d.y(), libm::hypot(d.x(), d.z()));
            let around = libm::atan2(d.x(), -d.z());
            let fields = (up / FRAC_PI_6).floor() + (around / FRAC_PI_6).floor();
            let light = 0.4 + 0.6 * fields.rem_euclid(2.0);
            let [green, blue] = [Color::new(0.3, 0.8, 0.3), Color::new(0.4, 0.6, 1.0)];
            (if d.y() < 0.0 { green } else { blue }) * light
        };
        render(&camera, paint, settings, &())
    });
}

variants! { check:
    yours => |basis, angle| Ok(Fisheye::new(basis, angle));
    wrong "the distance is the angle, not its tangent" => |Basis { e, v, w, .. }, angle| {
        PerspectiveCamera::new(e, -w, v, angle)
    };
}
