//! The curve of sRGB, there and back.

use crate::prelude::*;

/// The value of sRGB for linear light, both from 0 to 1.
pub fn encode(linear: f64) -> f64 {
    if linear <= 0.003_130_8 {
        return linear * 12.92;
    }
    1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
}

/// The linear light of a value of sRGB, both from 0 to 1.
pub fn decode(value: f64) -> f64 {
    if value <= 0.040_45 {
        return value / 12.92;
    }
    libm::pow((value + 0.055) / 1.055, 2.4)
}

testing::examples! {
    assert_close(encode(0.001), 0.012_92);
    assert_close(encode(1.0), 1.0);
    // With u = 0.75, u^12 to the power of 1 / 2.4 is u^5.
    assert_close(encode(libm::pow(0.75, 12.0)), 1.055 * libm::pow(0.75, 5.0) - 0.055);
    assert_close(decode(encode(0.5)), 0.5);
}
