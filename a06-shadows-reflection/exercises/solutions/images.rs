//! Where the images of a lamp stand between two mirrors.

use crate::prelude::*;

/// The place of the lamp's image after `n` reflections, as it is seen in the
/// left mirror at x = 0, and as it is seen in the right one at x = `width`.
///
/// The lamp itself, which is `n` = 0 on both sides, stands at x = `lamp`.
pub fn images(width: f64, lamp: f64, n: u32) -> [f64; 2] {
    missing!("the images in both mirrors", [lamp; 2], {
        // A mirror shows the image in the other one, one step earlier.
        (0..n).fold([lamp; 2], |[left, right], _| [-right, 2.0 * width - left])
    })
}

testing::examples! {
    assert_close!(images(10.0, 3.0, 0), [3.0, 3.0], "the lamp itself");
    assert_close!(images(10.0, 3.0, 1), [-3.0, 17.0]);
    assert_close!(images(10.0, 3.0, 2), [-17.0, 23.0]);
}
