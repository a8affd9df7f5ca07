//! Shadows on a slope, point by point. The points are computed, so that they lie
//! a little above the slope or below.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Hit, Interval, Plane, Sphere, World};
use a05_lighting::{DirectionalLight, Light, PointLight};
use common::{ArgumentError, Color};
use measure::Effort;
use measure::extremes::Protocol::Fails;
use measure::extremes::{Bound, Case};

use crate::{is_shadowed, protocol};

type Made<T> = Result<T, ArgumentError>;

pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(2_000, 20_000);
    vec![
        lamp_on_the_ceiling("I08", count),
        under_a_ball("S14", count, 1.0),
        under_a_ball("S31", count, 100.0),
        under_the_sun("S32", count),
    ]
}

/// Points of a tilted floor around the origin, computed as hits of rays.
struct Points {
    floor: Plane,
    normal: Vector3,
    size: f64,
}

impl Points {
    fn new(size: f64) -> Made<Self> {
        let normal = Vector3::new(0.3, 1.0, 0.2).unit("normal")?;
        let floor = Plane::new(Point3::ORIGIN, normal.as_normal())?;
        Ok(Self {
            floor,
            normal,
            size,
        })
    }

    /// The point at this height above the floor, in sizes of the scene.
    fn above(&self, height: f64) -> Point3 {
        Point3::ORIGIN + self.normal * (height * self.size)
    }

    /// Number of points for which a statement is true.
    fn count(&self, points: usize, is_wrong: impl Fn(&Ray, &Hit) -> bool) -> usize {
        let wrong = |i: &usize| {
            let random = PixelRandom::new(14, *i as u32, 0);
            let number = |n| 2.0 * random.uniform(n) - 1.0;
            let aside = self
                .normal
                .cross(Vector3::new(number(0), number(1), number(2)));
            let across = self.normal.cross(aside);
            let eye = self.above(3.0) + across * (4.0 * self.size);
            let target = Point3::ORIGIN + aside * (0.3 * self.size);
            let ray = Ray::new(eye, target - eye);
            ray.is_ok_and(|ray| {
                let hit = self.floor.hit(&ray, Interval::AHEAD);
                hit.is_some_and(|hit| is_wrong(&ray, &hit))
            })
        };
        (0..points).filter(wrong).count()
    }
}

/// A lamp that is fixed to the ceiling lights the floor.
fn lamp_on_the_ceiling(id: &'static str, count: usize) -> Case {
    let points = |wrong: fn(&World<()>, Point3, &Ray, &Hit) -> bool| {
        let points = Points::new(1.0)?;
        let lamp = points.above(4.0);
        let ceiling = Plane::new(lamp, Normal3::new(0.1, 1.0, 0.3))?;
        let world = World::new(Color::BLACK)?
            .with(points.floor, ())
            .with(ceiling, ());
        Ok::<_, ArgumentError>(points.count(count, |ray, hit| wrong(&world, lamp, ray, hit)))
    };
    let what = format!("lamp on the ceiling, {count} points below: dark");
    Case::new(id, what, 0.0, Bound::Equal, points(is_dark)).protocol(
        Fails,
        points(|world, lamp, ray, hit| {
            !protocol::point_light_illuminates(lamp, ray.at(hit.t), world)
        }),
    )
}

fn is_dark(world: &World<()>, lamp: Point3, ray: &Ray, hit: &Hit) -> bool {
    let light = PointLight::new(Color::WHITE, lamp).ok();
    let light = light.and_then(|light| light.illumination(ray.at(hit.t)));
    light.is_none_or(|light| is_shadowed(world, ray, hit, &light))
}

/// A ball on the floor, with a lamp straight above: the points below are dark.
fn under_a_ball(id: &'static str, count: usize, size: f64) -> Case {
    let points = |wrong: fn(&World<()>, Point3, &Ray, &Hit) -> bool| {
        let points = Points::new(size)?;
        let ball = Sphere::new(points.above(0.5), 0.5 * size)?;
        let world = World::new(Color::BLACK)?
            .with(points.floor, ())
            .with(ball, ());
        let lamp = points.above(5.0);
        Ok::<_, ArgumentError>(points.count(count, |ray, hit| wrong(&world, lamp, ray, hit)))
    };
    let what = format!(
        "ball of radius {} on a slope, {count} points under it: lit",
        0.5 * size
    );
    let ours = points(|world, lamp, ray, hit| !is_dark(world, lamp, ray, hit));
    Case::new(id, what, 0.0, Bound::Equal, ours).protocol(
        Fails,
        points(|world, lamp, ray, hit| {
            protocol::point_light_illuminates(lamp, ray.at(hit.t), world)
        }),
    )
}

/// An empty floor under a far light: all points are lit.
fn under_the_sun(id: &'static str, count: usize) -> Case {
    let points = |illuminated: fn(&World<()>, &DirectionalLight, Vector3, &Ray, &Hit) -> bool| {
        let points = Points::new(1.0)?;
        let direction = Vector3::new(0.1, -1.0, -0.4).unit("direction")?;
        let sun = DirectionalLight::new(Color::WHITE, direction)?;
        let world = World::new(Color::BLACK)?.with(points.floor, ());
        Ok::<_, ArgumentError>(points.count(count, |ray, hit| {
            !illuminated(&world, &sun, direction, ray, hit)
        }))
    };
    let what = format!("nothing on a slope under a far light, {count} points: dark");
    let ours = points(|world, sun, _, ray, hit| {
        let light = sun.illumination(ray.at(hit.t));
        light.is_some_and(|light| !is_shadowed(world, ray, hit, &light))
    });
    let theirs = points(|world, _, direction, ray, hit| {
        protocol::directional_light_illuminates(direction, ray.at(hit.t), world)
    });
    Case::new(id, what, 0.0, Bound::Equal, ours).protocol(Fails, theirs)
}
