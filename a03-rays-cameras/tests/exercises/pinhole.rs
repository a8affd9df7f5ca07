//! Pinhole cameras anywhere, compared with the lesson's.

use crate::prelude::*;

yours! { PinholeCamera => new_camera(|(e, angle)| PinholeCamera::new(point(e), angle)) }

/// Makes a camera of a pinhole and an angle.
type Code = NewCamera<([f64; 3], f64)>;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene(|new: &Code, settings, View { world: sky, .. }| {
            let camera = new(([0.0; 3], FRAC_PI_2))?;
            paint(&*camera, &|ray| sky.color_for(ray), settings)
        }),
        right: vec![Other::new("at the distance 1", at_distance_1(0.5))],
        wrong: vec![Other::new(
            "half of the angle is above the middle",
            at_distance_1(1.0),
        )],
        ..cameras(Cameras {
            words: "pinhole at {}, opening angle {}",
            first: ([0.0; 3], FRAC_PI_2),
            any: |r| (r.triple(9.0), r.between(0.2, 2.8)),
        })
    }
}

/// A pinhole with a picture at the distance 1, which sees this multiple of the angle above the
/// middle.
fn at_distance_1(factor: f64) -> Code {
    new_camera(move |(e, angle): (_, f64)| {
        let e = point(e);
        Ok(OwnCamera(move |[w, h]: [f64; 2], [x, y]: [f64; 2]| {
            let scale = 2.0 * libm::tan(factor * angle) / h;
            let right = (x - (w - 1.0) / 2.0) * scale;
            let up = (y - (h - 1.0) / 2.0) * scale;
            let d = Vector3::new(right, up, -1.0);
            Ray::derived(e, d.normalized().unwrap_or_default())
        }))
    })
}
