//! The length of a vector, however long or short it is.

use crate::prelude::*;

/// The length of the vector (`x`, `y`, `z`), whose coordinates are finite.
/// It is right up to a few roundings wherever it is no less than 1e-300 and not
/// beyond the greatest number.
pub fn length(x: f64, y: f64, z: f64) -> f64 {
    missing!("a length that does not overflow", x + y + z, {
        let largest = x.abs().max(y.abs()).max(z.abs());
        if largest == 0.0 {
            return 0.0;
        }
        // None of them is above 1, and no square of one that counts is lost.
        let [x, y, z] = [x, y, z].map(|coordinate| coordinate / largest);
        largest * (x * x + y * y + z * z).sqrt()
    })
}

testing::examples! {
    assert_close!(length(2.0, -3.0, 6.0), 7.0);
    assert_close!(length(3e200, 4e200, 0.0), 5e200);
    assert_close!(length(0.0, -3e-200, 4e-200) * 1e200, 5.0);
    assert_close!(length(0.0, 0.0, 0.0), 0.0);
}
