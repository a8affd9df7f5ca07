//! Rays that leave spheres and planes of all sizes to both sides, steep and grazing.

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Plane, Sphere};
use common::ArgumentError;
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

use crate::traced::{Tracer, expect_scene, frame, point, sphere};

pub fn check(check: &mut Check, leaving: impl Fn(&Ray, &Hit, Vector3) -> Ray + Sync) {
    let mut random = Random::new(62);
    for scale in [1.0, 1e-3, 1e3, 1e6, 1e-6] {
        for _ in 0..40 {
            let [n, side, _] = frame(&mut random);
            let Ok(shot) = Shot::new(&mut random, scale, n, side) else {
                continue;
            };
            for (height, how) in [(0.8, "steep"), (0.01, "grazing")] {
                for (sign, to) in [(1.0, "outwards"), (-1.0, "inwards")] {
                    let d = side * (1.0_f64 - height * height).sqrt() + n * (sign * height);
                    shot.expect_left(check, &format!("{how}, {to}"), d, &leaving);
                }
            }
        }
    }
    expect_scene(check, "sphere", sphere, |world, ray, depth| {
        Tracer {
            leaving: &leaving,
            ..Tracer::new(world)
        }
        .trace(ray, depth)
    });
}

/// Rays that hit a plane and a sphere which touches it, in a scene of some size.
struct Shot {
    scale: f64,
    ray: Ray,
    plane: Plane,
    sphere: Sphere,
}

impl Shot {
    fn new(
        random: &mut Random,
        scale: f64,
        n: Vector3,
        side: Vector3,
    ) -> Result<Self, ArgumentError> {
        let place = point(random, 5.0) - Point3::ORIGIN;
        let p = Point3::ORIGIN + place * scale;
        let from =
            p + n * (scale * random.between(0.5, 3.0)) + side * (scale * random.between(-3.0, 3.0));
        let radius = scale * random.between(0.5, 3.0);
        Ok(Self {
            scale,
            ray: Ray::new(from, p - from)?,
            plane: Plane::new(p, n.as_normal())?,
            sphere: Sphere::new(p - n * radius, radius)?,
        })
    }

    fn expect_left(
        &self,
        check: &mut Check,
        how: &str,
        d: Vector3,
        leaving: &impl Fn(&Ray, &Hit, Vector3) -> Ray,
    ) {
        let shapes: [(&str, &dyn Geometry); 2] = [("plane", &self.plane), ("sphere", &self.sphere)];
        for (name, shape) in shapes {
            let Some(hit) = shape.hit(&self.ray, Interval::AHEAD) else {
                continue;
            };
            let left = leaving(&self.ray, &hit, d);
            let words = format!(
                "scene of size {:e}, hit at {} with normal {:.3}, direction {:.3}",
                self.scale,
                self.ray.at(hit.t).to_glam(),
                hit.face.to_glam(),
                d.to_glam()
            );
            let [exact, got] = [d, left.direction()].map(|d| d.to_glam().to_array());
            check.expect(
                format!("the direction, {how}; {words}"),
                exact,
                Bound::Equal,
                got,
            );
            let step = left.origin() - self.ray.at(hit.t);
            let share = step.magnitude() / self.scale;
            let what = format!("the offset, as a share of the scene's size; {words}");
            check.expect(what, 0.0, Bound::Absolute(1e-9), share);
            let side = step.dot(hit.face) * d.dot(hit.face) > 0.0;
            check.expect(
                format!("offset to the side of the direction, {how}; {words}"),
                true,
                Bound::Equal,
                side,
            );
            // Inwards, a ray meets the far side of a sphere, but not this one.
            let near = Interval::before(1e-4 * self.scale);
            let again = shape.hit(&left, near).map(|hit| hit.t);
            check.expect(
                format!("t of a hit of the same {name}, {how}; {words}"),
                None::<f64>,
                Bound::Equal,
                again,
            );
        }
    }
}
