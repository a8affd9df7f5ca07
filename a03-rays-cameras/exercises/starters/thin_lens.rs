//! A thin lens: objects in focus are sharp, and all others are not.

use a02_math::Direction;
use a03_rays_cameras::{Basis, Ray};

/// The ray that a camera with this `basis` sends through the place
/// (`right`, `up`) of its lens, in lengths from the eye along `u` and `v`, instead
/// of `ray`, which starts in the eye. Both meet in the plane across the gaze
/// at the distance `focus`. The direction has length 1.
pub fn through_lens(basis: &Basis, focus: f64, ray: &Ray, (right, up): (f64, f64)) -> Ray {
    testing::missing("the ray through the lens", *ray)
}
