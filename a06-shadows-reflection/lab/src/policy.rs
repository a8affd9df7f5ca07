//! `Policy`: a rule for rays that leave a surface.

use a02_math::Point3;
use a02_math::arrays::array;
use a03_rays_cameras::Ray;
use a04_intersections::Interval;
use a04_lab::support::point;

use crate::lit_points::Trial;
use a06_shadows_reflection::secondary_ray;

/// A ray from a hit towards the light.
pub struct ShadowRay {
    pub ray: Ray,
    /// Where an object blocks the light.
    pub within: Interval,
}

impl ShadowRay {
    /// A ray that everything ahead of its origin blocks.
    pub const fn ahead(ray: Ray) -> Self {
        Self {
            ray,
            within: Interval::AHEAD,
        }
    }

    /// The ray from the computed point of a hit, which is blocked from this `t` on.
    pub fn from_point(trial: &Trial, min: f64) -> Self {
        Self {
            ray: Ray::derived(trial.point(), trial.light),
            within: Interval {
                min,
                ..Interval::AHEAD
            },
        }
    }
}

/// A rule for rays that leave a hit towards the light.
pub type Policy = fn(&Trial) -> ShadowRay;

/// Our policy: the offset of the origin.
pub fn offset(trial: &Trial) -> ShadowRay {
    ShadowRay::ahead(secondary_ray(&trial.ray, &trial.hit, trial.light))
}

/// From the computed point, with every positive `t`.
pub fn above_zero(trial: &Trial) -> ShadowRay {
    ShadowRay::from_point(trial, 0.0)
}

/// From the computed point, with a least `t` of a millionth.
pub fn above_a_millionth(trial: &Trial) -> ShadowRay {
    ShadowRay::from_point(trial, 1e-6)
}

/// The protocol's policy: from the computed point, and a least `t` of a thousandth.
pub fn above_a_thousandth(trial: &Trial) -> ShadowRay {
    ShadowRay::from_point(trial, 0.001)
}

/// A bound in proportion to the largest number of the hit.
pub fn relative(trial: &Trial) -> ShadowRay {
    let eye = trial.ray.origin().largest_coordinate();
    let point = trial.point().largest_coordinate();
    ShadowRay::from_point(trial, 1e-9 * eye.max(point).max(trial.hit.t))
}

/// The point is put back on its shape first, and then offset by its own numbers, not by those of
/// the way to it (Pharr, Jakob and Humphreys, Physically Based Rendering, 4th edition, section
/// 6.8), with our factor. Shapes that cannot put a point back offset it as it is.
pub fn put_back(trial: &Trial) -> ShadowRay {
    let surface = &trial.surface;
    let on_surface = surface.put_back(trial.point());
    let scale = on_surface.point.largest_coordinate().max(on_surface.scale);
    let offset = 64.0 * f64::EPSILON * scale;
    let origin = on_surface.point + trial.normal_to_the_light() * offset;
    ShadowRay::ahead(Ray::derived(origin, trial.light))
}

/// Each coordinate moves by a number of steps from one double to the next, and near 0 by a fixed
/// length (Wächter and Binder, A Fast and Robust Method for Avoiding Self-Intersection, Ray Tracing
/// Gems, 2019, chapter 6; its constants are for 24 binary digits, and the length has 29 more here).
pub fn stepped(trial: &Trial) -> ShadowRay {
    let normal = array(trial.normal_to_the_light());
    let mut origin = array(trial.point());
    for (x, n) in origin.iter_mut().zip(normal) {
        *x = if x.abs() < 1.0 / 32.0 {
            *x + n / 35_184_372_088_832.0
        } else {
            let steps = (256.0 * n).copysign(n * *x) as i64;
            f64::from_bits(x.to_bits().wrapping_add_signed(steps))
        };
    }
    let origin: Point3 = point(origin);
    ShadowRay::ahead(Ray::derived(origin, trial.light))
}
