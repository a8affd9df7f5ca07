//! Shadows on a slope, point by point. The points are computed, so that they lie
//! a little above the slope or below.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Hit, Interval, Plane, Sphere, World};
use a05_lighting::{DirectionalLight, Light, PointLight};
use common::{ArgumentError, Color, Error};
use measure::Effort;
use measure::extremes::{Case, Equal, Fails};

use crate::{is_shadowed, protocol};

/// All rows.
pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(2_000, 20_000);
    vec![
        lamp_on_the_ceiling("I08", count),
        under_a_ball("S14", count, 1.0),
        under_a_ball("S31", count, 100.0),
        under_the_sun("S32", count),
    ]
}

/// A tilted floor through the origin, in a scene of this size.
struct Slope {
    floor: Plane,
    normal: Vector3,
    size: f64,
}

impl Slope {
    fn new(size: f64) -> Result<Self, ArgumentError> {
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

    /// The floor with another object.
    fn world(&self, other: impl Geometry + 'static) -> Result<World<()>, Error> {
        Ok(World::new(Color::BLACK)?
            .with(self.floor, ())
            .with(other, ()))
    }

    /// Number of points around the origin, computed as hits of rays, for which a statement
    /// is true.
    fn count(&self, points: usize, is_wrong: impl Fn(&Ray, &Hit) -> bool) -> usize {
        let wrong = |i: &usize| {
            let random = PixelRandom::new(14, *i as u32, 0);
            let number = |n| 2.0 * random.uniform(n) - 1.0;
            let way = Vector3::new(number(0), number(1), number(2));
            let aside = self.normal.cross(way);
            let eye = self.above(3.0) + self.normal.cross(aside) * (4.0 * self.size);
            let target = Point3::ORIGIN + aside * (0.3 * self.size);
            Ray::new(eye, target - eye).is_ok_and(|ray| {
                let hit = self.floor.hit(&ray, Interval::AHEAD);
                hit.is_some_and(|hit| is_wrong(&ray, &hit))
            })
        };
        (0..points).filter(wrong).count()
    }
}

/// Whether a light, given with its position or direction, shines on a hit in a world.
type Illuminates<L, P> = fn(&World<()>, &(L, P), &Ray, &Hit) -> bool;

fn ours<L: Light, P>(world: &World<()>, (light, _): &(L, P), ray: &Ray, hit: &Hit) -> bool {
    let light = light.illumination(ray.at(hit.t));
    light.is_some_and(|light| !is_shadowed(world, ray, hit, &light))
}

const POINT_LIGHT: Illuminates<PointLight, Point3> = |world, (_, position), ray, hit| {
    protocol::point_light_illuminates(*position, ray.at(hit.t), world)
};

const FAR_LIGHT: Illuminates<DirectionalLight, Vector3> = |world, (_, direction), ray, hit| {
    protocol::directional_light_illuminates(*direction, ray.at(hit.t), world)
};

/// A row of points that are judged wrongly.
fn row<L: Light, P>(
    id: &'static str,
    what: String,
    theirs: Illuminates<L, P>,
    wrong: impl Fn(Illuminates<L, P>) -> Result<usize, Error>,
) -> Case {
    Case::new(id, what, 0.0, Equal, wrong(ours)).protocol(Fails, wrong(theirs))
}

/// A lamp that is fixed to the ceiling lights the floor.
fn lamp_on_the_ceiling(id: &'static str, count: usize) -> Case {
    let what = format!("lamp on the ceiling, {count} points below: dark");
    row(id, what, POINT_LIGHT, |is_lit| {
        let slope = Slope::new(1.0)?;
        let at = slope.above(4.0);
        let lamp = (PointLight::new(Color::WHITE, at)?, at);
        let world = slope.world(Plane::new(at, Normal3::new(0.1, 1.0, 0.3))?)?;
        Ok(slope.count(count, |ray, hit| !is_lit(&world, &lamp, ray, hit)))
    })
}

/// A ball on the floor, with a lamp straight above: the points below are dark.
fn under_a_ball(id: &'static str, count: usize, size: f64) -> Case {
    let radius = 0.5 * size;
    let what = format!("ball of radius {radius} on a slope, {count} points under it: lit");
    row(id, what, POINT_LIGHT, |is_lit| {
        let slope = Slope::new(size)?;
        let at = slope.above(5.0);
        let lamp = (PointLight::new(Color::WHITE, at)?, at);
        let world = slope.world(Sphere::new(slope.above(0.5), radius)?)?;
        Ok(slope.count(count, |ray, hit| is_lit(&world, &lamp, ray, hit)))
    })
}

/// An empty floor under a far light: all points are lit.
fn under_the_sun(id: &'static str, count: usize) -> Case {
    let what = format!("nothing on a slope under a far light, {count} points: dark");
    row(id, what, FAR_LIGHT, |is_lit| {
        let slope = Slope::new(1.0)?;
        let direction = Vector3::new(0.1, -1.0, -0.4).unit("direction")?;
        let sun = (DirectionalLight::new(Color::WHITE, direction)?, direction);
        let world = World::new(Color::BLACK)?.with(slope.floor, ());
        Ok(slope.count(count, |ray, hit| !is_lit(&world, &sun, ray, hit)))
    })
}
