//! `Question`: what a program is asked, as a value.

use crate::answers::Input;

/// A question to a program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Question {
    /// The question in words, which learners read.
    pub text: String,
    /// The numbers of the input.
    pub input: Vec<f64>,
    /// Whether the numbers are like 0, 1 and 2, which every formula computes without rounding:
    /// then decisions, such as that a ray that just touches hits, must be equal.
    pub is_simple: bool,
}

impl Question {
    /// The question with this input instead of each `{}` of the words.
    pub fn new(words: &str, input: &impl Input, is_simple: bool) -> Self {
        let (mut text, mut pieces) = (String::new(), words.split("{}"));
        for argument in input.words() {
            text += pieces.next().unwrap_or_default();
            text += &argument;
        }
        text.extend(pieces);
        Self {
            text,
            input: input.numbers(),
            is_simple,
        }
    }

    /// The input with each of its numbers a little larger and a little smaller, by `unit` of
    /// itself: so a zero stays what it is.
    pub fn perturbed(&self, unit: f64) -> impl Iterator<Item = [Vec<f64>; 2]> {
        (0..self.input.len()).map(move |which| {
            [unit, -unit].map(|change| {
                let mut perturbed = self.input.clone();
                perturbed[which] *= 1.0 + change;
                perturbed
            })
        })
    }
}
