//! The edges of stage 3, pixels of which the exact mean is known.

use a03_lab::experiments::{experiments, sampled};
use common::{Color, Error, Image, Size};
use measure::report::Measured;
use measure::scene_report::MIDDLE;

use super::Shown;

/// Some methods of the experiment of this name, if there is one. A regular grid of one sample has it in the
/// middle.
pub fn measured(name: &str, methods: &[&str]) -> Option<Measured<'static>> {
    let mut all = experiments().into_iter();
    let experiment = all.find(|known| known.name == name)?;
    let mut curves = Vec::new();
    for method in methods {
        let found = (experiment.curves)().into_iter();
        let mut found = found.filter(|curve| curve.method == known_as(method));
        curves.extend(found.next());
        if let Some(curve) = curves.last_mut().filter(|_| *method == MIDDLE.name) {
            curve.method = MIDDLE.name;
            curve.points.truncate(1);
        }
    }
    Some(Measured { experiment, curves })
}

/// The name of a method in the experiment.
fn known_as(method: &str) -> &str {
    if method == MIDDLE.name {
        "regular"
    } else {
        method
    }
}

/// The pixels of a method's point.
pub fn picture(name: &str, method: &str, point: usize) -> Result<Shown, Error> {
    let missing = || Error::Usage(format!("no picture of {method}"));
    let samples = 4_u32.pow(point as u32);
    let sampled = sampled(name, known_as(method), samples).ok_or_else(missing)?;
    // A single column of pixels is shown as several.
    let width = if sampled.width == 1 {
        40
    } else {
        sampled.width
    };
    let size = Size::new(width, sampled.lights.len() as u32 / width)?;
    let light = |x, y| Color::gray(sampled.lights[(y * width + x) as usize]);
    let mut errors = Vec::new();
    for (light, mean) in sampled.lights.iter().zip(&sampled.means) {
        errors.extend([light - mean; 3]);
    }
    Ok(Shown {
        image: Image::from_fn(size, light)?,
        errors,
    })
}
