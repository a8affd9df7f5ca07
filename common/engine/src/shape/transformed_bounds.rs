//! `transformed_bounds`: the bounds of a shape under a transform.
//!
//! Hits are computed with rays that are transformed by the inverse `i`. The matrix `m`
//! is the inverse of `i` only up to rounding. So the corners transformed by `m` are
//! bounds only after they have been widened by the rounding error.

use super::{Bounds, Transform};

/// Largest coordinates of `m` times those of `i`, the condition of the transform,
/// above which rounding moves hits too far for bounds to be of use.
const WORST_CONDITION: f64 = 1_048_576.0;

/// More than the rounding of a few products and sums, and of the formula of the
/// shape, relative to the largest number in them: 4096 units.
const ROUNDING: f64 = 4096.0 * f64::EPSILON;

/// The bounds of a shape that has these bounds before it is transformed.
pub(super) fn transformed_bounds(bounds: Bounds, transform: &Transform) -> Bounds {
    if !bounds.are_finite() {
        return Bounds::EVERYWHERE;
    }
    let rows = |matrix: glam::DMat4| matrix.transpose().to_cols_array_2d();
    let (m, i) = (rows(transform.matrix), rows(transform.inverse));
    let corners = bounds.corners();
    let around = Bounds::around(corners.map(|corner| transform.matrix.transform_point3(corner)));
    let largest = |axis: usize| around.min[axis].abs().max(around.max[axis].abs());
    let x = [largest(0), largest(1), largest(2), 1.0];

    let mut moved = around;
    for (row, m) in m.iter().enumerate().take(3) {
        // With p = i x + δ for a hit at x, the corners know m p, which is off by
        // (m i - 1) x + m δ. The formula of a shape mixes the coordinates, so that
        // each may have the error of the largest.
        let mut width = ROUNDING * m[3].abs();
        let reach: f64 = m[..3].iter().map(|entry| entry.abs()).sum();
        for column in 0..4 {
            let products = (0..4).map(|k| m[k] * i[k][column]);
            let largest = (0..3).fold(0.0, |largest, k| i[k][column].abs().max(largest));
            let condition = reach * largest;
            if column < 3 && condition > WORST_CONDITION {
                return Bounds::EVERYWHERE;
            }
            let one = f64::from(u8::from(row == column));
            let off = (products.sum::<f64>() - one).abs();
            width += (off + ROUNDING * condition) * x[column];
        }
        moved.min[row] -= width;
        moved.max[row] += width;
    }
    if moved.are_finite() {
        moved
    } else {
        Bounds::EVERYWHERE
    }
}

#[cfg(test)]
mod tests;
