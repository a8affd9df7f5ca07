//! The curve of sRGB, there and back.

/// The value of sRGB for linear light, both from 0 to 1.
pub fn encode(linear: f64) -> f64 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
    }
}

/// The linear light of a value of sRGB, both from 0 to 1.
pub fn decode(value: f64) -> f64 {
    // The same border, seen from the other side.
    if value <= 0.040_45 {
        value / 12.92
    } else {
        libm::pow((value + 0.055) / 1.055, 2.4)
    }
}
