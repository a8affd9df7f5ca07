//! The length of a vector, however long or short it is.

/// The length of the vector (`x`, `y`, `z`), whose coordinates are finite.
/// It is right up to a few roundings wherever it is no less than 1e-300 and not
/// beyond the greatest number.
pub fn length(x: f64, y: f64, z: f64) -> f64 {
    testing::missing(
        "a length that does not overflow",
        (x * x + y * y + z * z).sqrt(),
    )
}
