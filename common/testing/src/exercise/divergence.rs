//! The first step at which the traces of a pixel part, by the lesson and by a student's code.

use common::pixel_trace::digits;
use common::steps::{HIT, LIGHT, NO_HIT, Step};
use common::{Image, PixelTrace};

use crate::difference::largest;

/// The largest difference of numbers by rounding, relative to the larger of 1 and the number.
const ROUNDING: f64 = 1e-6;

/// The pixel in which a picture differs most from the expected one; the middle one if no channel
/// differs by more than 1 of 255.
#[must_use]
pub fn worst_pixel(expected: &Image, image: &Image) -> Option<[u32; 2]> {
    let (worst, most) = largest(expected, image)?;
    let size = image.size();
    let middle = [size.width() / 2, size.height() / 2];
    Some(if most > 1.5 / 255.0 { worst } else { middle })
}

/// A sentence about the first value that differs, or the first ray with a hit in one trace only,
/// or the first light that yours lacks, and the section of the book about it.
#[must_use]
pub fn first_divergence(lesson: &PixelTrace, yours: &PixelTrace) -> Option<String> {
    let decides = |place: &str, step: &Step| match step.kind {
        LIGHT => place.ends_with(": cl"),
        kind => kind == HIT || step.name == NO_HIT,
    };
    let ((place, step, right), yours) = lesson.first_difference(yours, decides, is_same)?;
    // Where four digits are equal, all are shown.
    let is_seen = yours.is_none_or(|yours| digits(yours) != digits(right));
    let all = |value: &[f64]| format!("{value:?}");
    let shown = |value| if is_seen { digits(value) } else { all(value) };
    let differs = match yours {
        Some(yours) => format!("yours {}{}", shown(yours), times(right, yours)),
        None if step.kind == HIT => "yours has no hit".to_owned(),
        None if step.kind == LIGHT => "yours lacks it".to_owned(),
        None => "yours has a hit".to_owned(),
    };
    let ([x, y], right, section) = (lesson.pixel, shown(right), step.section);
    Some(format!(
        "pixel ({x}, {y}): the same steps, up to\n  {place} is {right}, {differs}\n  \
         explained in book/src/{section}"
    ))
}

fn is_same(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= ROUNDING * a.abs().min(b.abs()).max(1.0)
}

/// Words about a multiple of a vector.
fn times(from: &[f64], to: &[f64]) -> String {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let factor = dot(from, to) / dot(from, from);
    let is_multiple = from.iter().zip(to).all(|(a, b)| is_same(a * factor, *b));
    if from.len() == 3 && factor != 0.0 && is_multiple {
        return format!(", {} times it", digits(&[factor]));
    }
    String::new()
}
