//! The length of a vector, however long or short it is.

use crate::prelude::*;

/// The length of the vector (`x`, `y`, `z`), whose coordinates are finite.
/// It is right up to a few roundings wherever it is no less than 1e-300 and not
/// beyond the greatest number.
pub fn length(x: f64, y: f64, z: f64) -> f64 {
    libm::hypot(libm::hypot(x, y), z)
}

testing::examples! {
    assert_close(length(2.0, -3.0, 6.0), 7.0);
    assert_close(length(3e200, 4e200, 0.0), 5e200);
    assert_close(length(0.0, -3e-200, 4e-200) * 1e200, 5.0);
    assert_eq!(length(0.0, 0.0, 0.0), 0.0);
}
