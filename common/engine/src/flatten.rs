//! `flatten`: replaces nested transforms by one.
//!
//! A ray that goes down through k transforms is moved k times. The product of their
//! matrices moves it at once, but rounds otherwise: both ways err by up to k times the
//! rounding of a product of a matrix and a point. So shapes are flattened only where the
//! picture may have an error.

use glam::DMat4;

use crate::shape::{Transform, Transformed, spectral_norm};

/// More than the error of both ways for each transform passed, relative to the largest
/// number on the way.
///
/// An inverse `i` takes a point at the distance r from the origin to one at most
/// r' = |i| r + c away, with its spectral norm |i| and the length c of its last column,
/// and rounds by at most √3 γ₄ r'. (γ₄ is hardly more than 2 eps; Higham, Accuracy and
/// Stability of Numerical Algorithms, 2002, section 3.5; the norm of the magnitudes of
/// three by three numbers is at most √3 |i|.) The transforms that follow stretch this no
/// more than r', so that k transforms err by at most k √3 γ₄ times the last distance.
/// The product of the matrices is computed in the same way column by column: with three
/// columns it errs by 3 γ₄, and by as much for k - 1 products and for the ray. Both ways
/// together stay below 10 eps; the norms are rounded, too.
const PER_TRANSFORM: f64 = 16.0 * f64::EPSILON;

/// Size of a pixel relative to the scene, in a picture of the whole scene 4096 pixels wide.
const PIXEL: f64 = 1.0 / 4096.0;

/// Replaces the transforms of a shape by their product if that displaces the shape, as each ray
/// sees it, by less than `max_error` of a pixel. `max_distance` is the
/// largest distance of eye and objects from the origin.
pub(crate) fn flatten(shape: &mut Transformed, max_distance: f64, max_error: f64) {
    if shape.steps.len() < 2 {
        return;
    }
    let (transform, displacement) = product(&shape.steps, max_distance);
    if transform.is_well_conditioned() && displacement < max_error * PIXEL * max_distance {
        shape.steps = vec![transform];
    }
}

/// The product of transforms, and an upper bound of its displacement against them one
/// by one.
///
/// A point at the distance r is at most `inwards` r + `far` from the origin in the space
/// of the object, and lengths there are at most `outwards` times as long outside. A ray
/// o + t d errs at a point x by the error of o and t times the error of d; together o
/// and x - o are no longer than three times the largest distance.
fn product(steps: &[Transform], max_distance: f64) -> (Transform, f64) {
    let mut all = Transform {
        matrix: DMat4::IDENTITY,
        inverse: DMat4::IDENTITY,
    };
    let (mut inwards, mut far, mut outwards) = (1.0, 0.0, 1.0);
    for transform in steps {
        all = Transform {
            matrix: all.matrix * transform.matrix,
            inverse: transform.inverse * all.inverse,
        };
        let norm = spectral_norm(transform.inverse);
        far = norm * far + transform.inverse.w_axis.truncate().length();
        inwards *= norm;
        outwards *= spectral_norm(transform.matrix);
    }
    let rounding = PER_TRANSFORM * steps.len() as f64 * outwards;
    (all, rounding * (3.0 * inwards * max_distance + far))
}

#[cfg(test)]
mod tests;
