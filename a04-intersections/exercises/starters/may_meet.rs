//! Whether a ray may meet the content of a sphere: a cheap question to ask
//! before an expensive one.

use a02_math::Point3;
use a03_rays_cameras::Ray;

/// Whether the ray, from its origin on, comes to within `r` of `c`. Where the
/// sphere is entered is not asked.
pub fn may_meet(c: Point3, r: f64, ray: &Ray) -> bool {
    testing::missing("whether the ray comes near enough", true)
}
