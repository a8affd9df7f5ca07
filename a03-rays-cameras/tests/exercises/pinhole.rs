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
        right: vec![Other::new("at the distance 1", at_distance_1())],
        wrong: mistakes_with_angle(|(e, angle)| Ok((axes(e)?, angle))),
        ..cameras(Cameras {
            words: "pinhole at {}, field of view {}",
            first: ([0.0; 3], FRAC_PI_2),
            further: vec![],
            any: |r| (r.triple(9.0), r.between(0.2, 2.8)),
            section: "a03-rays-cameras.md#pinhole",
        })
    }
}

/// A pinhole at a point, as a camera that looks along -z.
fn axes(e: [f64; 3]) -> Made<Basis> {
    let (gaze, up) = (Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
    Basis::new(point(e), gaze, up)
}

/// A pinhole with a picture at the distance 1.
fn at_distance_1() -> Code {
    new_camera(|(e, angle): (_, f64)| {
        let e = point(e);
        Ok(OwnCamera(move |[w, h]: [f64; 2], [x, y]: [f64; 2]| {
            let scale = 2.0 * libm::tan(0.5 * angle) / h;
            let right = (x - (w - 1.0) / 2.0) * scale;
            let up = (y - (h - 1.0) / 2.0) * scale;
            let d = Vector3::new(right, up, -1.0);
            Ray::derived(e, d.normalized().unwrap_or_default())
        }))
    })
}
