//! Light that a surface sends back, as numbers without limit and as the protocol has it.

use a02_math::{Direction, Vector3};
use a04_lab::protocol::byte;
use a05_lab::protocol::{clamped_product, integer_product};
use common::{Color, Image, Size};

use super::Answered;
use crate::picture::pixels;

/// Width and height of the picture of a ball, in pixels.
const BALL: u32 = 146;

/// Numbers: the light that arrives, and the fraction that the surface sends back. The picture
/// has three matt balls in this light, by our product and by the protocol's two.
pub fn answer([light, fraction]: [f64; 2]) -> Answered {
    let products = |light: f64| {
        let ours = Color::gray(light) * Color::gray(fraction);
        [
            ours.r,
            clamped_product(light, fraction),
            integer_product(light, fraction),
        ]
    };
    let to_light = Vector3::new(-0.48, 0.64, 0.6);
    let image = Image::from_fn(Size::new(3 * BALL, BALL)?, |column, row| {
        let [x, y] =
            [column % BALL, BALL - 1 - row].map(|i| f64::from(2 * i + 1) / f64::from(BALL) - 1.0);
        let square = x * x + y * y;
        if square > 0.9 {
            return Color::gray(0.1);
        }
        let normal = Vector3::new(x, y, libm::sqrt(0.9 - square)) * (1.0 / libm::sqrt(0.9));
        let arriving = light * normal.dot(to_light).max(0.0);
        Color::gray(products(arriving)[(column / BALL) as usize])
    })?;
    let [product, clamped, whole] = products(light);
    let to_byte = |channel: f64| f64::from(Color::gray(channel).to_bytes()[0]);
    Ok(pixels(&image)
        .with("product", [product])
        .with("byte", [to_byte(product)])
        .with("cut_byte", [f64::from(byte(product))])
        .with("clamped", [clamped])
        .with("clamped_byte", [to_byte(clamped)])
        .with("whole", [whole])
        .with("whole_byte", [to_byte(whole)]))
}
