//! Directions and colours of the numbers of a question.

use a02_math::Vector3;
use a02_math::arrays::vector;
use common::Color;
use testing::exercises::Random;

/// The direction of length 1; all zeros where there is none.
#[must_use]
pub fn unit(xyz: [f64; 3]) -> Vector3 {
    vector(xyz).normalized().unwrap_or_default()
}

/// The colour of these channels.
#[must_use]
pub fn color([r, g, b]: [f64; 3]) -> Color {
    Color::new(r, g, b)
}

/// The channels of a random colour, from 0 to 1.5.
pub fn channels(random: &mut Random) -> [f64; 3] {
    [(); 3].map(|()| random.between(0.0, 1.5))
}
