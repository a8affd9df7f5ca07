//! Shadows on a slope, point by point. The points are computed, so that they lie
//! a little above the slope or below.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::support::Numbers;
use a04_intersections::{Geometry, Interval, Plane, Sphere, World};
use a05_lighting::{DirectionalLight, Light, PointLight};
use common::{ArgumentError, Color, Error};
use measure::Effort;
use measure::extremes::Case;

use crate::{is_shadowed, protocol};

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let n = effort.choose(2_000, 20_000);
    let ball = |radius: f64| format!("ball of radius {radius} on a slope, {n} points under it: lit");
    vec![
        Case::wrong("I08", format!("lamp on the ceiling, {n} points below: dark"), lamp_on_the_ceiling(n)),
        Case::wrong("S14", ball(0.5), under_a_ball(n, 1.0)),
        Case::wrong("S31", ball(50.0), under_a_ball(n, 100.0)),
        Case::wrong("S32", format!("nothing on a slope under a far light, {n} points: dark"), under_the_sun(n)),
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

    /// Of some points around the origin, computed as hits of rays, the number that is not
    /// `lit` as it should be: by our shadow rays, and by the protocol's.
    fn wrong(
        &self,
        points: usize,
        (world, light, lit): (&World<()>, &dyn Light, bool),
        theirs: impl Fn(Point3) -> bool,
    ) -> Counts {
        let mut wrong = [0; 2];
        for i in 0..points {
            let aside = self.normal.cross(Numbers::new(14, i).triple(-1.0, 1.0));
            let eye = self.above(3.0) + self.normal.cross(aside) * (4.0 * self.size);
            let target = Point3::ORIGIN + aside * (0.3 * self.size);
            let ray = Ray::new(eye, target - eye)?;
            if let Some(hit) = self.floor.hit(&ray, Interval::AHEAD) {
                let point = ray.at(hit.t);
                let light = light.illumination(point);
                let ours = light.is_some_and(|light| !is_shadowed(world, &ray, &hit, &light));
                wrong[0] += usize::from(ours != lit);
                wrong[1] += usize::from(theirs(point) != lit);
            }
        }
        Ok(wrong)
    }
}

/// Points that are judged wrongly, by us and by the protocol.
type Counts = Result<[usize; 2], Error>;

/// A lamp that is fixed to the ceiling lights the floor.
fn lamp_on_the_ceiling(count: usize) -> Counts {
    let slope = Slope::new(1.0)?;
    let at = slope.above(4.0);
    let lamp = PointLight::new(Color::WHITE, at)?;
    let world = slope.world(Plane::new(at, Normal3::new(0.1, 1.0, 0.3))?)?;
    slope.wrong(count, (&world, &lamp, true), |point| {
        protocol::point_light_illuminates(at, point, &world)
    })
}

/// A ball on the floor, with a lamp straight above: the points below are dark.
fn under_a_ball(count: usize, size: f64) -> Counts {
    let slope = Slope::new(size)?;
    let at = slope.above(5.0);
    let lamp = PointLight::new(Color::WHITE, at)?;
    let world = slope.world(Sphere::new(slope.above(0.5), 0.5 * size)?)?;
    slope.wrong(count, (&world, &lamp, false), |point| {
        protocol::point_light_illuminates(at, point, &world)
    })
}

/// An empty floor under a far light: all points are lit.
fn under_the_sun(count: usize) -> Counts {
    let slope = Slope::new(1.0)?;
    let direction = Vector3::new(0.1, -1.0, -0.4).unit("direction")?;
    let sun = DirectionalLight::new(Color::WHITE, direction)?;
    let world = World::new(Color::BLACK)?.with(slope.floor, ());
    slope.wrong(count, (&world, &sun, true), |point| {
        protocol::directional_light_illuminates(direction, point, &world)
    })
}
