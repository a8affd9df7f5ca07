//! Stiff and extreme cases of cameras and stripes, and of the mean of samples: the rows of `cases.toml`.

mod cameras;
mod stripes;

use a02_math::Vector3;
use common::Color;
use measure::Effort;
use measure::extremes::{Case, Row, rows};

use crate::protocol;

pub fn cases(effort: Effort) -> Vec<Case> {
    rows(include_str!("../cases.toml"), effort, computed)
}

/// What a row asks, by our code and by the protocol's formula.
fn computed(row: &Row) -> Case {
    match row.asks.as_str() {
        "stripes at the horizon" => Case::of_wrong(stripes::at_the_horizon()),
        "stripes down the middle" => Case::of_wrong(stripes::down_the_middle()),
        "rows of several stripes" => Case::of_wrong(stripes::rows_of_several()),
        "byte of a mean" => mean_of_bytes(),
        _ => cameras::computed(row),
    }
}

pub const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);
pub const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// The byte of the mean of four gray samples, summed as linear colours.
fn mean_of_bytes() -> Case {
    let bytes = [205, 205, 205, 204];
    let mut sum = Color::BLACK;
    for byte in bytes {
        sum += Color::from_bytes([byte; 3]);
    }
    let [ours, ..] = (sum * 0.25).to_bytes();
    Case::of(f64::from(ours), f64::from(protocol::mean_byte(&bytes)))
}
