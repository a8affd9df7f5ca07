//! `Policy`: a rule for rays that leave a surface.

use a02_math::Direction;
use a02_math::arrays::array;
use a03_rays_cameras::Ray;
use a04_intersections::Interval;
use a04_lab::line::Line;
use a04_lab::number::Number;
use a04_lab::support::point;

use crate::form::{Form, OnSurface};
use crate::lit_points::Trial;
use a06_shadows_reflection::secondary_ray;

/// A ray from a hit towards the light.
pub struct ShadowRay {
    pub ray: Ray,
    /// Where an object blocks the light.
    pub within: Interval,
    /// How objects are tested for it.
    pub test: Test,
}

/// A way to test whether a ray hits an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Test {
    /// The lesson's.
    Lesson,
    /// The lesson's in single precision, in which the numbers of the ray are.
    Single,
    /// A hit counts only if it is ahead whatever the rounding errors of its `t` are.
    Certain,
}

impl ShadowRay {
    /// A ray that everything ahead of its origin blocks.
    pub const fn ahead(ray: Ray) -> Self {
        Self {
            ray,
            within: Interval::AHEAD,
            test: Test::Lesson,
        }
    }

    /// Whether a shape of this form blocks the ray, by another test than the lesson's.
    pub fn hits(&self, form: &Form) -> bool {
        let line = Line::of(&self.ray);
        match self.test {
            Test::Lesson => form.hit(&line).is_some(),
            Test::Single => form.hit(&line.to::<f32>()).is_some(),
            Test::Certain => form.is_certainly_hit(&line),
        }
    }

    /// The ray from the computed point of a hit, which is blocked from this `t` on.
    pub fn from_point(trial: &Trial, min: f64) -> Self {
        Self {
            within: Interval {
                min,
                ..Interval::AHEAD
            },
            ..Self::ahead(Ray::derived(trial.point(), trial.light))
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

/// The protocol's policy: from the computed point, and a least `t` of a thousandth.
pub fn above_a_thousandth(trial: &Trial) -> ShadowRay {
    ShadowRay::from_point(trial, 0.001)
}

/// A bound in proportion to `t`, as in the second edition of Physically Based Rendering (pbrt-v2,
/// `Triangle::Intersect` in `src/shapes/trianglemesh.cpp`): a thousandth of `t` for 24 binary digits,
/// and 29 more here.
pub fn relative_to_t(trial: &Trial) -> ShadowRay {
    ShadowRay::from_point(trial, trial.hit.t / 536_870_912_000.0)
}

/// A bound in proportion to the largest number of the hit.
pub fn relative(trial: &Trial) -> ShadowRay {
    let eye = trial.ray.origin().largest_coordinate();
    let point = trial.point().largest_coordinate();
    ShadowRay::from_point(trial, 1e-9 * eye.max(point).max(trial.hit.t))
}

/// The point is reprojected onto its shape, and moves along the normal until it has left the box of its
/// error bounds, with one more step to the next double (Pharr, Jakob and Humphreys, Physically Based
/// Rendering, 4th edition, section 6.8.6). Shapes count a hit only if it is ahead beyond the error of
/// its `t` (section 6.8.7). Intervals give this error for all shapes; the bounds in the book take less
/// time.
pub fn error_bounds(trial: &Trial) -> ShadowRay {
    let OnSurface { point: p, error } = trial.reproject();
    let normal = trial.normal_to_the_light();
    let offset = array(normal * error.dot_of_magnitudes(normal));
    let mut origin = array(p);
    for (x, offset) in origin.iter_mut().zip(offset) {
        *x += offset;
        if offset > 0.0 {
            *x = x.next_up();
        } else if offset < 0.0 {
            *x = x.next_down();
        }
    }
    ShadowRay {
        test: Test::Certain,
        ..ShadowRay::ahead(Ray::derived(point(origin), trial.light))
    }
}

/// The point is reprojected onto its shape. Each coordinate moves by a number of steps from one double to
/// the next, and near 0 by a fixed length (Wächter and Binder, A Fast and Robust Method for Avoiding
/// Self-Intersection, Ray Tracing Gems, 2019, chapter 6; its constants are for 24 binary digits, and
/// the length has 29 more here). The shapes that cannot reproject a point move it as it is.
pub fn stepped(trial: &Trial) -> ShadowRay {
    let normal = array(trial.normal_to_the_light());
    let mut origin = array(trial.reproject().point);
    for (x, n) in origin.iter_mut().zip(normal) {
        *x = if x.abs() < 1.0 / 32.0 {
            *x + n / 35_184_372_088_832.0
        } else {
            let steps = (256.0 * n).copysign(n * *x) as i64;
            f64::from_bits(x.to_bits().wrapping_add_signed(steps))
        };
    }
    ShadowRay::ahead(Ray::derived(point(origin), trial.light))
}

/// Our policy in single precision, from the first hit to the test of the shadow ray.
pub fn single(trial: &Trial) -> ShadowRay {
    let line = Line::of(&trial.ray).to::<f32>();
    let t = trial.surface.form.and_then(|form| form.hit(&line));
    // The rim of a shape may be missed.
    let t = t.unwrap_or(f32::of(trial.hit.t));
    let [normal, light] = [trial.normal_to_the_light(), trial.light].map(|v| array(v).map(f32::of));
    let point = [0, 1, 2].map(|axis| line.origin[axis] + t * line.direction[axis]);
    let mut largest = t.max(f32::of(trial.hit.scale));
    for coordinate in line.origin.into_iter().chain(point) {
        largest = largest.max(coordinate.abs());
    }
    let offset = 64.0 * f32::EPSILON * largest;
    let origin = [0, 1, 2].map(|axis| point[axis] + normal[axis] * offset);
    let leaving = Line {
        origin,
        direction: light,
    };
    ShadowRay {
        test: Test::Single,
        ..ShadowRay::ahead(leaving.in_doubles().raw_ray())
    }
}
