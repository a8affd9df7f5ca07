//! Vectors of all lengths, compared with the solution.

use crate::prelude::*;

yours! { angle }

type Code = fn(Vector3, Vector3) -> f64;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: StudentPicture::own(fans),
        ..Exercise::asked(|angle: &Code, (a, b)| angle(vector(a), vector(b)))
    }
}

/// The angles from an arrow to the points around it, in sectors of 15 degrees; and on the right
/// those to points that are almost on the arrow, in bands of a hundred-millionth.
fn fans(angle: &Code, settings: &Settings) -> Result<Image, Error> {
    let arrow = Vector3::new(1.0, 0.0, 0.0);
    Image::from_fn(settings.size, |x, y| {
        let [x, up] = [f64::from(x), 120.0 - f64::from(y)];
        if x < 160.0 {
            // Lengths from 0 to 2.
            let to_point = Vector3::new((x - 80.0) / 60.0, up / 60.0, 0.0);
            return in_bands(angle(arrow, to_point) / std::f64::consts::PI, 12.0);
        }
        let largest = 1e-7;
        let to_point = Vector3::new(1.0, up / 120.0 * largest, 0.0);
        in_bands(angle(arrow, to_point) / largest, 10.0)
    })
}

/// A colour from blue at 0 to orange at 1, in this number of bands, every other one darker.
fn in_bands(fraction: f64, bands: f64) -> Color {
    let color = Color::new(0.1, 0.3, 0.8) * (1.0 - fraction) + Color::new(1.0, 0.6, 0.1) * fraction;
    if ((fraction * bands) as u32).is_multiple_of(2) {
        color
    } else {
        color * 0.75
    }
}
