//! Pinhole cameras anywhere, compared with the lesson's.

use crate::prelude::*;

pub fn check<C: Camera>(check: &mut Check, new: impl Fn(Point3, f64) -> Made<C>) {
    compare(
        check,
        "pinhole at {}, opening angle {}",
        ([0.0; 3], FRAC_PI_2),
        |r| (r.triple(9.0), r.between(0.2, 2.8)),
        |(e, angle)| PinholeCamera::new(point(e), angle),
        |(e, angle)| new(point(e), angle),
    );
    scene(check, |settings, View { world: sky, .. }| {
        let camera = new(Point3::ORIGIN, FRAC_PI_2)?;
        paint(&camera, &|ray| sky.color_for(ray), settings)
    });
}

/// A pinhole with a picture at the distance 1, which sees the angle times a factor.
fn variant(c: &mut Check, factor: f64) {
    check(c, move |e, angle| {
        Ok(Own(move |[w, h]: [f64; 2], [x, y]: [f64; 2]| {
            let scale = 2.0 * libm::tan(factor * angle) / h;
            let [right, up] = [x - (w - 1.0) / 2.0, y - (h - 1.0) / 2.0].map(|p| p * scale);
            let way = Vector3::new(right, up, -1.0);
            Ray::derived(e, way.normalized().unwrap_or_default())
        }))
    });
}

variants! { variant:
    yours => PinholeCamera::new;
    right "at the distance 1" => 0.5;
    wrong "half of the angle is above the middle" => 1.0;
}
