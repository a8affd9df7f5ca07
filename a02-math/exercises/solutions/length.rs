//! The length of a vector, however long or short it is.

/// The length of the vector (`x`, `y`, `z`), whose coordinates are finite.
/// It is right up to a few roundings wherever it is no less than 1e-300 and not
/// beyond the greatest number.
pub fn length(x: f64, y: f64, z: f64) -> f64 {
    let largest = x.abs().max(y.abs()).max(z.abs());
    if largest == 0.0 {
        return 0.0;
    }
    // None of them is above 1, and no square of one that counts is lost.
    let [x, y, z] = [x, y, z].map(|coordinate| coordinate / largest);
    largest * (x * x + y * y + z * z).sqrt()
}
