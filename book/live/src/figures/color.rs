//! Light that a surface sends back, as numbers without limit and as the protocol has it.

use a04_intersections::lab::protocol::byte;
use a05_lighting::lab::protocol::{clamped_product, integer_product};
use common::Color;

use crate::Answer;

/// Numbers: the light that arrives, and the share that the surface sends back.
pub fn answer([light, share]: [f64; 2]) -> Answer {
    let product = Color::gray(light) * Color::gray(share);
    let clamped = clamped_product(light, share);
    let whole = integer_product(light, share);
    let to_byte = |channel: f64| f64::from(Color::gray(channel).to_bytes()[0]);
    Answer::default()
        .with("product", [product.r])
        .with("byte", [to_byte(product.r)])
        .with("cut_byte", [f64::from(byte(product.r))])
        .with("clamped", [clamped])
        .with("clamped_byte", [to_byte(clamped)])
        .with("whole", [whole])
        .with("whole_byte", [to_byte(whole)])
}
