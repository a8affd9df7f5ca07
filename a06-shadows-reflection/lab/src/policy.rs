//! `Policy`: a rule for rays that leave a surface.

use a03_rays_cameras::Ray;
use a04_intersections::Interval;

use crate::lit_points::LitPoint;
use a06_shadows_reflection::secondary_ray;

/// A ray from a hit towards the light.
pub struct ShadowRay {
    pub ray: Ray,
    /// Where an object blocks the light.
    pub within: Interval,
}

/// A rule for rays that leave a hit towards the light.
pub type Policy = fn(&LitPoint) -> ShadowRay;

/// Our policy: the offset of the origin.
pub fn offset(lit: &LitPoint) -> ShadowRay {
    ShadowRay {
        ray: secondary_ray(&lit.ray, &lit.hit, lit.light),
        within: Interval::AHEAD,
    }
}

/// From the computed point, with every positive `t`.
pub fn above_zero(lit: &LitPoint) -> ShadowRay {
    from_point(lit, 0.0)
}

/// The protocol's policy: from the computed point, and a least `t` of a thousandth.
pub fn above_a_thousandth(lit: &LitPoint) -> ShadowRay {
    from_point(lit, 0.001)
}

/// A bound in proportion to `t`, as in the second edition of Physically Based Rendering (pbrt-v2,
/// `Triangle::Intersect` in `src/shapes/trianglemesh.cpp`): a thousandth of `t` for 24 binary digits,
/// and 29 more here.
pub fn relative_to_t(lit: &LitPoint) -> ShadowRay {
    from_point(lit, lit.hit.t / 536_870_912_000.0)
}

/// The ray from the computed point of a hit, which is blocked from this `t` on.
fn from_point(lit: &LitPoint, min: f64) -> ShadowRay {
    ShadowRay {
        ray: Ray::derived(lit.point(), lit.light),
        within: Interval {
            min,
            ..Interval::AHEAD
        },
    }
}
