//! The formulas of this stage as the two texts print them, mistakes included:
//! only for comparison, and to render pictures of the mistakes.

pub use a02_lab::protocol::normalized;
use a02_math::{Point3, Vector3};

/// The axes u, v, w of a camera, unchecked: NaN if gaze and up vector are
/// parallel, or if one of them is very long or short.
pub fn axes(gaze: Vector3, up: Vector3) -> [Vector3; 3] {
    let w = -normalized(gaze);
    let u = normalized(up.cross(w));
    [u, w.cross(u), w]
}

/// The orthographic bracket of the text's code: the fraction cancels to `p - 1`,
/// and is 0 / 0 in a picture one pixel wide.
pub fn bracket_of_the_code(p: f64, n: f64) -> f64 {
    let [numerator, denominator] = [(n - 1.0) / 2.0; 2];
    p - numerator / denominator
}

/// The orthographic bracket of the text's formula: it subtracts a constant
/// fraction from the pixel instead of dividing the pixel.
pub fn bracket_of_the_formula(p: f64, n: f64) -> f64 {
    p - (n - 1.0) / (n + 1.0)
}

/// The orthographic bracket of the course: 0 / 0 in a picture one pixel wide.
pub fn bracket_of_the_course(p: f64, n: f64) -> f64 {
    (p - (n - 1.0) / 2.0) / (n - 1.0)
}

/// The direction of the perspective camera at the origin that looks along -z:
/// right only if `alpha` is half of the field of view.
pub fn perspective_direction([w, h]: [f64; 2], px: f64, py: f64, alpha: f64) -> Vector3 {
    let z = -(h / 2.0) / libm::tan(alpha);
    normalized(Vector3::new(px - (w - 1.0) / 2.0, py - (h - 1.0) / 2.0, z))
}

/// The direction of the pinhole camera, in which whole numbers `x` and `y` are
/// corners of pixels, not their middles.
pub fn pinhole_direction([w, h]: [f64; 2], x: f64, y: f64, alpha: f64) -> Vector3 {
    let z = -((h / 2.0) / libm::tan(alpha / 2.0));
    normalized(Vector3::new(x - w / 2.0, h / 2.0 - y, z))
}

/// Like [`pinhole_direction`], but halves width and height as whole numbers,
/// which loses a half for odd sizes.
pub fn pinhole_direction_of_whole_sizes(size: [u32; 2], x: f64, y: f64, alpha: f64) -> Vector3 {
    let even = size.map(|n| f64::from(n / 2 * 2));
    pinhole_direction(even, x, y, alpha)
}

/// The point of a ray up to a bound. The text sets it to 30, which hides farther
/// points, although its sky is infinite.
pub fn point_at(origin: Point3, direction: Vector3, upper_bound: f64, t: f64) -> Option<Point3> {
    let within = t >= 0.0 && t <= upper_bound;
    within.then(|| origin + normalized(direction) * t)
}

/// The number of a stripe, computed by subtracting stripe heights from the top:
/// every step rounds, and the sign of the height is ignored, so that the two
/// stripes beside the horizon become one.
pub fn count_current_stripe(top: f64, stripes: u32, direction_y: f64) -> u32 {
    let stripe_height = top * 2.0 / f64::from(stripes);
    let (mut count, mut i) = (0, top);
    while i >= 0.0 {
        if direction_y.abs() <= i {
            count += 1;
        }
        i -= stripe_height;
    }
    count
}

/// The mean of bytes by integer division, which truncates.
pub fn mean_byte(samples: &[u8]) -> u8 {
    let sum: usize = samples.iter().map(|byte| usize::from(*byte)).sum();
    (sum / samples.len()) as u8
}
