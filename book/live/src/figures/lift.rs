//! Shadow rays that leave their surface by any length: from acne to detached shadows.

use a06_shadows_reflection::secondary_ray;
use a07_mistakes::go_wrong::{by, shadows, sunwards};
use common::{Settings, Size};

use super::Answered;
use crate::picture::pixels;

/// Number: the lift as a power of ten; below -17 there is none. Counts the pixels that
/// differ from the picture with the lift of the lesson.
pub fn answer([power]: [f64; 1]) -> Answered {
    let settings = Settings {
        size: Size::new(240, 240)?,
        ..Settings::default()
    };
    let lift = if power < -17.0 {
        0.0
    } else {
        libm::pow(10.0, power)
    };
    let lifted = shadows(|ray, hit| by(lift, ray, hit), &settings, &())?;
    let right = shadows(
        |ray, hit| secondary_ray(ray, hit, sunwards()),
        &settings,
        &(),
    )?;
    let pairs = lifted.pixels().iter().zip(right.pixels());
    let wrong = pairs.filter(|(lifted, right)| lifted != right).count();
    Ok(pixels(&lifted)
        .with("lift", [lift])
        .with("wrong_pixels", [wrong as f64]))
}
