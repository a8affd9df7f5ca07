//! The formulas of the protocol as it prints them, mistakes included. The
//! tables hold them against what is right, and only pictures of the mistakes
//! are rendered with them.

#![expect(
    clippy::must_use_candidate,
    reason = "for tables and pictures of mistakes"
)]

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Interval, World};
use common::Color;

use crate::{RecursiveTracer, ShadowedWorld};

/// Wrong: nearer than a thousandth is asked only of the nearest hit, so that
/// the surface itself hides what casts the shadow. And `t`, which counts in
/// lengths of the direction, is compared with a distance, so that things behind
/// the light cast shadows.
pub fn point_light_illuminates<S>(position: Point3, point: Point3, world: &World<S>) -> bool {
    let to_light = position - point;
    let hit = world.hit(&Ray::derived(point, to_light), Interval::AHEAD);
    !hit.is_some_and(|(hit, _)| hit.t < to_light.magnitude() && hit.t > 0.001)
}

/// Wrong: the ray goes from the point away from the light. (The cone aside.)
pub fn spot_light_illuminates<S>(position: Point3, point: Point3, world: &World<S>) -> bool {
    let from_light = point - position;
    let hit = world.hit(&Ray::derived(point, from_light), Interval::AHEAD);
    !hit.is_some_and(|(hit, _)| hit.t < from_light.magnitude())
}

/// Wrong: any hit counts, that of the surface itself, too.
pub fn directional_light_illuminates<S>(
    direction: Vector3,
    point: Point3,
    world: &World<S>,
) -> bool {
    let ray = Ray::derived(point, -direction);
    world.hit(&ray, Interval::AHEAD).is_none()
}

/// Wrong for a light at the point itself: 0 / 0 is NaN, which the `max` of
/// Java, unlike that of Rust, does not hide.
pub fn lambert(n: Normal3, position: Point3, point: Point3) -> f64 {
    let way = position - point;
    let cosine = n.dot(way * (1.0 / way.magnitude()));
    if cosine.is_nan() {
        cosine
    } else {
        cosine.max(0.0)
    }
}

/// Wrong: the reflection stands inside of the sum over the lights. It counts
/// once for each, and not at all without any.
pub fn reflection_inside_sum(own: &[f64], k: f64, reflected: f64) -> f64 {
    own.iter().fold(0.0, |sum, own| sum + own + k * reflected)
}

/// The tracer of the protocol.
///
/// Wrong: its one counter is never restored, so it counts rays and not depth;
/// at the limit it returns the background; and the reflected ray begins a
/// thousandth before the hit, however small the scene is. And every hit is
/// searched for three times.
pub struct OneCounter<'a> {
    pub world: &'a ShadowedWorld,
    pub recursion: u32,
}

impl OneCounter<'_> {
    pub fn trace(&mut self, ray: &Ray) -> Color {
        let background = self.world.objects().background();
        if self.recursion < 1 {
            return background;
        }
        let search = || self.world.objects().hit(ray, Interval::AHEAD);
        if search().is_none() {
            return background;
        }
        // Searched again for the material, and once more for its argument.
        let (Some((_, surface)), Some((hit, _))) = (search(), search()) else {
            return background;
        };
        self.recursion -= 1;
        let lighting = RecursiveTracer::new(self.world);
        let color = surface.color_for(ray, &hit, &lighting);
        let direction = (-ray.direction()).reflected_on(hit.normal);
        let reflected = Ray::derived(ray.at(hit.t - 0.001), direction);
        color + surface.reflection() * self.trace(&reflected)
    }
}

/// On whole numbers the formulas give what they say, so that nothing but the
/// extreme cases makes them fail there.
#[cfg(test)]
mod tests {
    use super::*;
    use a04_intersections::Plane;
    use a05_lighting::SingleColor;

    use crate::Reflective;

    const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

    fn at(y: f64) -> Point3 {
        Point3::new(0.0, y, 0.0)
    }

    /// A floor at this height.
    fn floor(y: f64) -> World<()> {
        let plane = Plane::new(at(y), UP.as_normal()).unwrap();
        World::new(Color::BLACK).unwrap().with(plane, ())
    }

    /// From 0 to a light at 4: `t` is 0.25 at 1, and 4, a distance, at 16.
    #[test]
    fn a_point_light_is_dark_if_t_lies_between_a_thousandth_and_its_distance() {
        for (y, lit) in [
            (-1.0, true),
            (0.004, true),
            (0.005, false),
            (1.0, false),
            (15.0, false),
            (16.0, true),
        ] {
            assert_eq!(
                point_light_illuminates(at(4.0), at(0.0), &floor(y)),
                lit,
                "{y}"
            );
        }
    }

    /// The same below the point, where the ray goes.
    #[test]
    fn a_spot_light_is_dark_by_what_lies_behind_the_point() {
        for (y, lit) in [(1.0, true), (-1.0, false), (-15.0, false), (-16.0, true)] {
            assert_eq!(
                spot_light_illuminates(at(4.0), at(0.0), &floor(y)),
                lit,
                "{y}"
            );
        }
    }

    #[test]
    fn a_directional_light_is_dark_below_anything() {
        for (y, lit) in [(1.0, false), (1e9, false), (-1.0, true)] {
            assert_eq!(directional_light_illuminates(-UP, at(0.0), &floor(y)), lit);
        }
    }

    #[test]
    fn the_cosine_is_not_clamped_where_it_is_no_number() {
        let n = UP.as_normal();
        let cosine = |x, y| lambert(n, Point3::new(x, y, 0.0), Point3::ORIGIN);
        assert_eq!((cosine(3.0, 4.0), cosine(3.0, -4.0)), (0.8, 0.0));
        assert!(cosine(0.0, 0.0).is_nan());
    }

    #[test]
    fn the_reflection_counts_once_for_each_light() {
        assert_eq!(reflection_inside_sum(&[], 0.5, 4.0), 0.0);
        assert_eq!(reflection_inside_sum(&[1.0], 0.5, 4.0), 3.0);
        assert_eq!(reflection_inside_sum(&[1.0, 8.0], 0.5, 4.0), 13.0);
    }

    /// The floor mirrors the ceiling, or at the limit the background instead of
    /// black.
    #[test]
    fn the_counter_counts_rays() {
        let (grey, black) = (Color::gray(0.5), Color::BLACK);
        let mirror = Reflective::new(black, black, 1.0, grey).unwrap();
        let [floor, ceiling] = [0.0, 2.0].map(|y| Plane::new(at(y), UP.as_normal()).unwrap());
        let world = ShadowedWorld::empty(Color::WHITE, black)
            .unwrap()
            .with(floor, Box::new(mirror))
            .with(ceiling, Box::new(SingleColor::new(Color::RED).unwrap()));
        let world = &world;
        let trace = |recursion| OneCounter { world, recursion }.trace(&Ray::derived(at(1.0), -UP));
        assert_eq!(trace(0), Color::WHITE);
        assert_eq!(trace(1), grey);
        assert_eq!(trace(2), Color::RED * 0.5);
    }
}
