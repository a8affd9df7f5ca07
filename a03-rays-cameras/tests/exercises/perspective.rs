//! Perspective cameras anywhere, compared with the lesson's.

use crate::prelude::*;

pub fn check<C: Camera>(check: &mut Check, new: impl Fn(Point3, Vector3, Vector3, f64) -> Made<C>) {
    let (gaze, up) = ([0.0, 0.0, -1.0], [0.0, 1.0, 0.0]);
    compare(
        check,
        "eye, gaze and up {}, opening angle {}",
        ([[0.0; 3], gaze, up], FRAC_PI_2),
        |r| ([(); 3].map(|()| r.triple(5.0)), r.between(0.2, 2.8)),
        |([e, g, t], angle)| PerspectiveCamera::new(point(e), vector(g), vector(t), angle),
        |([e, g, t], angle)| new(point(e), vector(g), vector(t), angle),
    );
    scene(check, |settings, View { world: sky, .. }| {
        let camera = new(Point3::ORIGIN, vector(gaze), vector(up), FRAC_PI_2)?;
        paint(&camera, &|ray| sky.color_for(ray), settings)
    });
}

/// A camera with another v, from w and the up vector.
fn variant(c: &mut Check, v: fn(Vector3, Vector3) -> Vector3) {
    let unit = |v: Vector3| v.normalized().unwrap_or_default();
    check(c, move |e, g, t, angle| {
        let w = unit(-g);
        let v = unit(v(w, t));
        Ok(Own(move |[width, height]: [f64; 2], [x, y]: [f64; 2]| {
            // The height of the picture is 2.
            let [x, y] = [x - (width - 1.0) / 2.0, y - (height - 1.0) / 2.0];
            let aside = (v.cross(w) * x + v * y) * (2.0 / height);
            Ray::derived(e, unit(aside - w * (1.0 / libm::tan(angle / 2.0))))
        }))
    });
}

variants! { variant:
    yours => PerspectiveCamera::new;
    right "the part of the up vector across the gaze" => |w, t| t - w * t.dot(w);
    wrong "v is perpendicular to w, and t is not" => |_, t| t;
}
