//! The curve of sRGB, there and back.

/// The value of sRGB for linear light, both from 0 to 1.
pub fn encode(linear: f64) -> f64 {
    testing::missing("the value for linear light", linear)
}

/// The linear light of a value of sRGB, both from 0 to 1.
pub fn decode(value: f64) -> f64 {
    testing::missing("the linear light of a value", value)
}
