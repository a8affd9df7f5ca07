//! Pictures whose mean over a pixel has a closed form. Lengths are in pixels; a
//! pixel is identified by its corner (`x`, `y`).

use std::f64::consts::FRAC_PI_4;

/// The middle and the radius of the disc whose edge is sampled.
const MIDDLE: [f64; 2] = [31.7, 32.3];
const RADIUS: f64 = 20.3;

pub fn in_disc(x: f64, y: f64) -> bool {
    let (x, y) = (x - MIDDLE[0], y - MIDDLE[1]);
    x * x + y * y <= RADIUS * RADIUS
}

/// Coverage of a pixel by the disc, from 0 to 1.
pub fn disc_coverage(x: f64, y: f64) -> f64 {
    over_corners(corner_of_disc, x - MIDDLE[0], y - MIDDLE[1], 1.0)
}

/// The integral over the square at (`x`, `y`) of a function with the integral
/// `corner` over the quadrant to the left of and below a corner.
fn over_corners(corner: fn(f64, f64) -> f64, x: f64, y: f64, side: f64) -> f64 {
    corner(x + side, y + side) - corner(x, y + side) - corner(x + side, y) + corner(x, y)
}

/// The area of the disc around 0 that is left of `x` and below `y`.
fn corner_of_disc(x: f64, y: f64) -> f64 {
    let r = RADIUS;
    let (x, y) = (x.clamp(-r, r), y.clamp(-r, r));
    // The half disc above the axis, from the left up to t.
    let half = |t: f64| {
        let triangle = 0.5 * t * (r * r - t * t).sqrt();
        let sector = r * r * (0.5 * libm::asin(t / r) + FRAC_PI_4);
        triangle + sector
    };
    // Left of x and farther than |y| from the axis, on one side of it.
    let width = ((r - y) * (r + y)).sqrt();
    let end = x.min(width);
    let cut = if end > -width {
        half(end) - half(-width) - y.abs() * (end + width)
    } else {
        0.0
    };
    if y >= 0.0 { 2.0 * half(x) - cut } else { cut }
}

/// Height of two stripes, no multiple of a pixel.
const PERIOD: f64 = 5.236_067_977_499_79;

/// Whether a height lies in a light stripe.
pub fn in_stripe(y: f64) -> bool {
    2.0 * (y / PERIOD).fract() < 1.0
}

/// Coverage of a pixel by light stripes, from 0 to 1.
pub fn stripes(y: f64) -> f64 {
    let below = |y: f64| {
        let half = PERIOD / 2.0;
        let whole = (y / PERIOD).floor();
        whole * half + (y - whole * PERIOD).min(half)
    };
    below(y + 1.0) - below(y)
}
