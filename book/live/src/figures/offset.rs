//! Shadow rays that leave their surface by any length: from acne to detached shadows.

use a06_shadows_reflection::secondary_ray;
use a07_lab::go_wrong::{by, shadows, sunwards};
use common::{Settings, Size};

use super::Answered;
use crate::picture::pixels;

/// Number: the offset as a power of ten; below -17 there is none. Counts the pixels that
/// differ from the picture with the offset of the lesson.
pub fn answer([power]: [f64; 1]) -> Answered {
    let settings = Settings {
        size: Size::new(240, 240)?,
        ..Settings::default()
    };
    let offset = if power < -17.0 {
        0.0
    } else {
        libm::pow(10.0, power)
    };
    let picture = shadows(|ray, hit| by(offset, ray, hit), &settings, &())?;
    let right = shadows(
        |ray, hit| secondary_ray(ray, hit, sunwards()),
        &settings,
        &(),
    )?;
    let pairs = picture.pixels().iter().zip(right.pixels());
    let wrong = pairs.filter(|(offset, right)| offset != right).count();
    Ok(pixels(&picture)
        .with("offset", [offset])
        .with("wrong_pixels", [wrong as f64]))
}
