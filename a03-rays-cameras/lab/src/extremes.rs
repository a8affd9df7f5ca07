//! Stiff and extreme cases of cameras and stripes, and of the mean of samples.

mod cameras;
mod stripes;

use a02_math::Vector3;
use common::Color;
use measure::Effort;
use measure::extremes::{Absolute, Case, Fails, Known, Number};

use crate::protocol;

pub fn cases(_: Effort) -> Vec<Case> {
    let mut cases = [cameras::cases(), stripes::cases()].concat();
    cases.push(mean_of_bytes());
    cases
}

pub const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);
pub const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

fn mean_of_bytes() -> Case {
    let bytes = [205, 205, 205, 204];
    Case {
        id: "Q13".into(),
        what: "the byte of the samples 205, 205, 205 and 204, averaged as whole numbers".into(),
        exact: Number(204.75),
        condition: Known(1.0),
        bound: Absolute(0.5),
        protocol: Fails,
        ..Case::of(
            f64::from(byte_of_mean(bytes)),
            f64::from(protocol::mean_byte(&bytes)),
        )
    }
}

/// The byte of the mean of four gray samples, summed as linear colours.
fn byte_of_mean(bytes: [u8; 4]) -> u8 {
    let mut sum = Color::BLACK;
    for byte in bytes {
        sum += Color::from_bytes([byte; 3]);
    }
    (sum * 0.25).to_bytes()[0]
}
