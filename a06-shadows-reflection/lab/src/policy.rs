//! `Policy`: a rule for rays that leave a surface.

use a02_math::Point3;
use a02_math::arrays::array;
use a03_rays_cameras::Ray;
use a04_intersections::Interval;
use a04_lab::support::point;

use crate::lit_points::Trial;
use a06_shadows_reflection::secondary_ray;

/// A rule for rays that leave a hit towards the light: the ray and its interval.
pub type Policy = fn(&Trial) -> (Ray, Interval);

/// Our policy: the offset of the origin.
pub const OFFSET: Policy = |trial| {
    let ray = secondary_ray(&trial.ray, &trial.hit, trial.light);
    (ray, Interval::AHEAD)
};

/// The protocol's policy: from the computed point, and a least `t` of a thousandth.
pub const THOUSANDTH: Policy = |trial| trial.from_point(0.001);

/// A bound in proportion to the largest number of the hit.
pub const RELATIVE: Policy = |trial| {
    let points = [trial.ray.origin(), trial.point()];
    let [eye, point] = points.map(Point3::largest_coordinate);
    trial.from_point(1e-9 * eye.max(point).max(trial.hit.t))
};

/// The point is put back on its shape first, and then offset by its own numbers, not by those of
/// the way to it (Pharr, Jakob and Humphreys, Physically Based Rendering, 4th edition, section
/// 6.8), with our factor. Shapes that cannot put a point back offset it as it is.
pub const PUT_BACK: Policy = |trial| {
    let point = trial.point();
    let put_back = trial.surface.put_back.as_deref();
    let (point, scale) = put_back.map_or((point, 0.0), |put_back| put_back(point));
    let offset = 64.0 * f64::EPSILON * point.largest_coordinate().max(scale);
    let origin = point + trial.normal_to_the_light() * offset;
    (Ray::derived(origin, trial.light), Interval::AHEAD)
};

/// Each coordinate moves by a number of steps from one double to the next, and near 0 by a fixed
/// length (Wächter and Binder, A Fast and Robust Method for Avoiding Self-Intersection, Ray Tracing
/// Gems, 2019, chapter 6; its constants are for 24 binary digits, and the length has 29 more here).
pub const STEPPED: Policy = |trial| {
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
    let ray = Ray::derived(point(origin), trial.light);
    (ray, Interval::AHEAD)
};
