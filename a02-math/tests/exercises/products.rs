//! Products of vectors, compared with the solution.

use crate::prelude::*;

yours! { dot, cross => crate::products::Code { dot, cross } }

#[derive(Clone, Copy)]
pub struct Code {
    pub dot: fn(Vector3, Vector3) -> f64,
    pub cross: fn(Vector3, Vector3) -> Vector3,
}

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(balls),
        ..Exercise::asked(|code: &Code, (a, b)| {
            let (a, b) = (vector(a), vector(b));
            Answer::named("a · b", (code.dot)(a, b)).and("a × b", array((code.cross)(a, b)))
        })
    }
}

/// Two balls: the brightness of one is the dot product of normal and light. The colour of the other,
/// which rotates, is where a point moves: by the cross product of the axis and its position.
fn balls(code: &Code, settings: &Settings) -> Result<Image, Error> {
    let light = Vector3::new(-0.36, 0.48, 0.8);
    let axis = Vector3::new(0.36, 0.8, 0.48);
    Image::from_fn(settings.size, |x, y| {
        let is_left = x < 160;
        let middle = if is_left { 80.0 } else { 240.0 };
        let [right, up] = [f64::from(x) - middle, 120.0 - f64::from(y)].map(|n| n / 70.0);
        let squared = 1.0 - right * right - up * up;
        if squared < 0.0 {
            return Color::WHITE;
        }
        let normal = Vector3::new(right, up, squared.sqrt());
        if is_left {
            let brightness = (code.dot)(normal, light).clamp(0.0, 1.0);
            return Color::new(1.0, 0.6, 0.2) * (0.08 + 0.92 * brightness);
        }
        let [r, g, b] = array((code.cross)(axis, normal)).map(|n| 0.5 + 0.5 * n);
        Color::new(r, g, b)
    })
}
