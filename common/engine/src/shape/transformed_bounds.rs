//! `transformed_bounds`: the bounds of a shape under a chain of transforms.
//!
//! Hits are computed with rays that are transformed by the inverses, one after the other.
//! The product `m` of the matrices is the inverse of the product `i` of the inverses only
//! up to rounding. So the shape transformed by `m` has its bounds only after they have been
//! widened by the rounding error.

use glam::{DMat4, DVec3};

use super::transform::WORST_CONDITION;
use super::{Bounds, Transform};

/// More than the rounding of a few products and sums for each transform, and of the
/// formula of the shape, relative to the largest number in them: 4096 units.
const ROUNDING: f64 = 4096.0 * f64::EPSILON;

/// The bounds of a shape with this support function under transforms, the outermost first.
pub(super) fn transformed_bounds(steps: &[Transform], support: impl Fn(DVec3) -> f64) -> Bounds {
    let matrices = || steps.iter().map(|step| step.matrix);
    let inverses = || steps.iter().rev().map(|step| step.inverse);
    let rows = |matrix: DMat4| matrix.transpose().to_cols_array_2d();
    let (m, i) = (rows(matrices().product()), rows(inverses().product()));
    // No sum on the way is larger than the sum of the magnitudes.
    let abs_m = rows(matrices().map(magnitudes).product());
    let abs_i = rows(inverses().map(magnitudes).product());

    let around = Bounds::from_support(|axis, sign| {
        let [x, y, z, w] = m[axis];
        support(DVec3::new(x, y, z) * sign) + w * sign
    });
    let [x, y, z] = around.magnitudes();
    let rounding = ROUNDING * steps.len() as f64;

    let mut moved = around;
    for row in 0..3 {
        // With p = i x + δ for a hit at x, the shape knows m p, which is off by
        // (m i - 1) x + m δ. The formula of a shape mixes the coordinates, so that
        // each may have the error of the largest.
        let mut width = rounding * abs_m[row][3];
        let row_sum: f64 = abs_m[row][..3].iter().sum();
        for column in 0..4 {
            let products = (0..4).map(|k| m[row][k] * i[k][column]);
            let largest = (0..3).fold(0.0, |largest, k| abs_i[k][column].max(largest));
            let condition = row_sum * largest;
            if column < 3 && condition > WORST_CONDITION {
                return Bounds::EVERYWHERE;
            }
            let one = f64::from(u8::from(row == column));
            let off = (products.sum::<f64>() - one).abs();
            width += (off + rounding * condition) * [x, y, z, 1.0][column];
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

/// The magnitudes of all entries.
fn magnitudes(matrix: DMat4) -> DMat4 {
    DMat4::from_cols_array(&matrix.to_cols_array().map(f64::abs))
}

#[cfg(test)]
mod tests;
