//! Where the images of a lamp stand between two mirrors.

/// The place of the lamp's image after `n` reflections, as it is seen in the
/// left mirror at x = 0, and as it is seen in the right one at x = `width`.
///
/// The lamp itself, which is `n` = 0 on both sides, stands at x = `lamp`.
pub fn images(width: f64, lamp: f64, n: u32) -> [f64; 2] {
    // A mirror shows the image in the other one, one step earlier.
    let mut images = [lamp; 2];
    for _ in 0..n {
        let [left, right] = images;
        images = [-right, 2.0 * width - left];
    }
    images
}
