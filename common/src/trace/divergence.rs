//! The first step at which the traces of a pixel part, by two renderers or by two people's code.

use std::collections::HashMap;
use std::fmt;

use crate::PixelTrace;
use crate::pixel_trace::{Value, digits};
use crate::steps::StepKind;

/// The largest difference of numbers by rounding, relative to the larger of 1 and the number.
pub const ROUNDING: f64 = 1e-6;

/// The first value that differs between two traces of a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Divergence {
    /// Column and row of the pixel.
    pub pixel: [u32; 2],
    /// The value in both traces, in words.
    pub words: String,
    /// The section of the book about it.
    pub section: &'static str,
}

impl fmt::Display for Divergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (difference, section) = (self.difference(), self.section);
        write!(f, "{difference}\n  explained in book/src/{section}")
    }
}

impl Divergence {
    /// The pixel and the value, without the section.
    #[must_use]
    pub fn difference(&self) -> String {
        let ([x, y], words) = (self.pixel, &self.words);
        format!("pixel ({x}, {y}): the same steps, up to\n  {words}")
    }
}

impl PixelTrace {
    /// The first value that differs from the other trace's by more than this `rounding`. If the
    /// other trace follows rays, it may lack no ray's hit and no light.
    #[must_use]
    pub fn first_divergence(&self, other: &Self, whose: &str, rounding: f64) -> Option<Divergence> {
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
            let is_test = step.kind == StepKind::Test;
            let differs = match others.get(&place) {
                Some(theirs) if are_near(value, theirs, rounding) => return None,
                Some([f64::INFINITY]) if is_test => "has no hit".to_owned(),
                Some(theirs) => {
                    let mut others = digits(theirs);
                    // Where four digits are equal, all are shown.
                    if others == shown {
                        [shown, others] = [value, theirs].map(|value| format!("{value:?}"));
                    }
                    others + &times(value, theirs)
                }
                None if !follows_rays => return None,
                None if step.kind == StepKind::Hit => {
                    let ray = place.rsplit_once(", ").map(|(ray, _)| ray);
                    let lacks_ray =
                        ray.is_some_and(|ray| !others.keys().any(|place| place.starts_with(ray)));
                    let words = if lacks_ray {
                        "lacks this ray"
                    } else {
                        "has no hit"
                    };
                    words.to_owned()
                }
                None if step.kind == StepKind::Background => "has a hit".to_owned(),
                None if step.kind == StepKind::Light && symbol == "cl" => "lacks it".to_owned(),
                None => return None,
            };
            let words = if is_test && *value == [f64::INFINITY] {
                let test = place.trim_end_matches(": t");
                format!("{test} has no hit, {whose} has one: t is {differs}")
            } else {
                format!("{place} is {shown}, {whose} {differs}")
            };
            Some(Divergence {
                pixel: self.pixel,
                words,
                section: step.section,
            })
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
    const TEST: (StepKind, &str) = (StepKind::Test, "Sphere");

    fn trace(kinds: &[(StepKind, &str)], number: f64) -> PixelTrace {
        let mut steps = Vec::new();
        for (kind, name) in kinds {
            steps.push(Step::new(*kind, *name, "page").with("x", [number]));
        }
        of_steps(steps)
    }

    fn of_steps(steps: Vec<Step>) -> PixelTrace {
        PixelTrace {
            pixel: [1, 2],
            color: Color::BLACK,
            steps,
        }
    }

    #[test]
    fn traces_part_at_another_number_or_at_a_missing_hit() {
        let ours = trace(&[RAY, HIT], 1.0);
        let first = |kinds: &[(StepKind, &str)], number| {
            ours.first_divergence(&trace(kinds, number), "yours", ROUNDING)
        };
        let words = |kinds, number| first(kinds, number).unwrap().words;
        assert_eq!(first(&[HIT], 1.0 + 1e-9), None);
        assert_eq!(words(&[RAY, HIT], 2.0), "ray: x is 1, yours 2");
        let digits = "hit: x is [1.0], yours [1.00001]";
        assert_eq!(words(&[HIT], 1.00001), digits);
        assert_eq!(words(&[RAY], 1.0), "hit: x is 1, yours has no hit");
        let text = first(&[RAY, HIT], 2.0).unwrap().to_string();
        let lines = [
            "pixel (1, 2): the same steps, up to",
            "  ray: x is 1, yours 2",
            "  explained in book/src/page",
        ];
        assert_eq!(text, lines.join("\n"));
    }

    /// Where the other code follows no further ray, nobody has asked for a hit.
    #[test]
    fn a_ray_that_is_not_followed_is_no_ray_without_a_hit() {
        let mut hit = Step::new(HIT.0, HIT.1, "page").with("x", [1.0]);
        hit.level = 1;
        let ray = Step::new(RAY.0, RAY.1, "page").with("x", [1.0]);
        let reflected = Step::new(StepKind::ReflectedRay, "reflected ray", "page");
        let words = |theirs| {
            let ours = of_steps(vec![ray.clone(), reflected.clone(), hit.clone()]);
            let parts = ours.first_divergence(&of_steps(theirs), "yours", ROUNDING);
            parts.unwrap().words
        };
        assert_eq!(
            words(vec![ray.clone()]),
            "reflected ray, hit: x is 1, yours lacks this ray"
        );
        let followed = reflected.clone().with("y", [1.0]);
        assert_eq!(
            words(vec![ray.clone(), followed]),
            "reflected ray, hit: x is 1, yours has no hit"
        );
    }

    #[test]
    fn a_test_without_a_hit_has_no_number() {
        let missed = Step::new(TEST.0, TEST.1, "page");
        let hit = of_steps(vec![missed.clone().with("t", [4.5])]);
        let missed = of_steps(vec![missed]);
        let words = |ours: &PixelTrace, theirs| {
            let parts = ours.first_divergence(theirs, "yours", ROUNDING);
            parts.unwrap().words
        };
        assert_eq!(words(&hit, &missed), "Sphere: t is 4.5, yours has no hit");
        assert_eq!(
            words(&missed, &hit),
            "Sphere has no hit, yours has one: t is 4.5"
        );
        assert_eq!(missed.first_divergence(&missed, "yours", ROUNDING), None);
    }
}
