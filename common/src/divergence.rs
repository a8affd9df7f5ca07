//! The first step at which the traces of a pixel part, by two renderers or by two people's code.

use std::collections::HashMap;

use crate::PixelTrace;
use crate::pixel_trace::{Value, digits};
use crate::steps::StepKind;

/// The largest difference of numbers by rounding, relative to the larger of 1 and the number.
pub const ROUNDING: f64 = 1e-6;

impl PixelTrace {
    /// A sentence about the first value that differs from the other trace's by more than this
    /// `rounding`, and the section of the book about it. If the other trace follows rays, it may
    /// lack no ray's hit and no light.
    #[must_use]
    pub fn first_divergence(&self, other: &Self, whose: &str, rounding: f64) -> Option<String> {
        let others = other.values().map(|value| (value.place, value.numbers));
        let others: HashMap<_, _> = others.collect();
        let follows_rays = other
            .steps
            .iter()
            .any(|step| step.kind == StepKind::CameraRay);
        self.values().find_map(|value| {
            let Value {
                place,
                step,
                symbol,
                numbers: value,
            } = value;
            let mut shown = digits(value);
            let differs = match others.get(&place) {
                Some(theirs) if are_near(value, theirs, rounding) => return None,
                Some(theirs) => {
                    let mut others = digits(theirs);
                    // Where four digits are equal, all are shown.
                    if others == shown {
                        [shown, others] = [value, theirs].map(|value| format!("{value:?}"));
                    }
                    others + &times(value, theirs)
                }
                None if !follows_rays => return None,
                None if step.kind == StepKind::Hit => "has no hit".to_owned(),
                None if step.kind == StepKind::Background => "has a hit".to_owned(),
                None if step.kind == StepKind::Light && symbol == "cl" => "lacks it".to_owned(),
                None => return None,
            };
            let ([x, y], section) = (self.pixel, step.section);
            Some(format!(
                "pixel ({x}, {y}): the same steps, up to\n  {place} is {shown}, {whose} \
                 {differs}\n  explained in book/src/{section}"
            ))
        })
    }
}

fn are_near(a: &[f64], b: &[f64], rounding: f64) -> bool {
    let is_near =
        |(a, b): (&f64, &f64)| a == b || (a - b).abs() <= rounding * a.abs().min(b.abs()).max(1.0);
    a.iter().zip(b).all(is_near)
}

/// Words about a multiple of a vector.
fn times(from: &[f64], to: &[f64]) -> String {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let factor = dot(from, to) / dot(from, from);
    let multiple: Vec<_> = from.iter().map(|number| number * factor).collect();
    if from.len() == 3 && factor != 0.0 && are_near(&multiple, to, ROUNDING) {
        return format!(", {} times it", digits(&[factor]));
    }
    String::new()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Color;
    use crate::steps::Step;

    const RAY: (StepKind, &str) = (StepKind::CameraRay, "ray");
    const HIT: (StepKind, &str) = (StepKind::Hit, "hit");

    fn trace(kinds: &[(StepKind, &str)], number: f64) -> PixelTrace {
        let step = |(kind, name): &(StepKind, &str)| Step::new(*kind, *name, "page");
        PixelTrace {
            pixel: [1, 2],
            color: Color::BLACK,
            steps: kinds
                .iter()
                .map(|kind| step(kind).with("x", [number]))
                .collect(),
        }
    }

    #[test]
    fn traces_part_at_another_number_or_at_a_missing_hit() {
        let ours = trace(&[RAY, HIT], 1.0);
        let first = |kinds: &[(StepKind, &str)], number| {
            let sentence = ours.first_divergence(&trace(kinds, number), "yours", ROUNDING);
            sentence.map(|sentence| sentence.lines().nth(1).unwrap_or_default().to_owned())
        };
        assert_eq!(first(&[HIT], 1.0 + 1e-9), None);
        assert_eq!(first(&[RAY, HIT], 2.0).unwrap(), "  ray: x is 1, yours 2");
        let digits = "  hit: x is [1.0], yours [1.00001]";
        assert_eq!(first(&[HIT], 1.00001).unwrap(), digits);
        assert_eq!(
            first(&[RAY], 1.0).unwrap(),
            "  hit: x is 1, yours has no hit"
        );
    }
}
