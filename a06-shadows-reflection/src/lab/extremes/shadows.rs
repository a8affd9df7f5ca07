//! Lights in unusual positions, and the protocol's shadow rays.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::support::Numbers;
use a04_intersections::watched::geometry;
use a04_intersections::{Geometry, Interval, Plane, Sphere, World};
use a05_lighting::{DirectionalLight, Lambert, Light, PointLight, SpotLight, watched};
use common::tally::{self, Work};
use common::{ArgumentError, Color, Error};
use measure::Effort;
use measure::extremes::{Case, Equal, Fails, Holds, Id, Protocol, tried, wrong};

use crate::lab::protocol::{
    directional_light_illuminates, lambert, point_light_illuminates, spot_light_illuminates,
};
use crate::{LightSource, RecursiveTracer, ShadowedWorld, is_shadowed};

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);
/// Position of the lights that a ball may hide.
const LAMP: Point3 = Point3::new(0.0, 4.0, 0.0);

fn floor() -> Result<Plane, ArgumentError> {
    Plane::new(Point3::ORIGIN, UP)
}

/// A white floor, ambient light of 1/4, and one more light.
fn world(light: LightSource) -> Result<ShadowedWorld, Error> {
    let world = ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?;
    let white = Box::new(Lambert::new(Color::WHITE)?);
    Ok(world.with(floor()?, white).lit_by(light))
}

fn point_light(position: Point3) -> Result<LightSource, ArgumentError> {
    let light = PointLight::new(Color::WHITE, position)?;
    Ok(LightSource::new(light, true))
}

/// The colour of the floor at the origin, seen from straight above.
fn brightness(id: Id, what: &str, light: Point3, exact: f64) -> Case {
    let ours = tried(|| {
        let ray = Ray::derived(Point3::new(0.0, 1.0, 0.0), DOWN);
        let world = world(point_light(light)?)?;
        Ok(RecursiveTracer::new(&world).trace(&ray, 1).r)
    });
    Case::new(id, format!("{what}: brightness below"), exact, Equal, ours)
}

/// A ray to the origin, past the objects above it.
fn look() -> Ray {
    Ray::derived(Point3::new(-3.0, 4.0, 0.0), Vector3::new(0.6, -0.8, 0.0))
}

/// Number of rays tested against the floor, without the camera's ray.
fn shadow_rays(id: Id, what: &str, light: Point3) -> Case {
    let ours = tried(|| {
        let world = watched::world(world(point_light(light)?)?, geometry, |surface| surface);
        let trace = || RecursiveTracer::new(&world).trace(&look(), 1);
        let (_, tally) = tally::counted(trace)?;
        Ok(tally[Work::IntersectionTest] as f64 - 1.0)
    });
    Case::new(id, format!("{what}: shadow rays"), 0.0, Equal, ours)
}

/// The protocol's function of a light.
type Illuminates = fn(Point3, Point3, &World<()>) -> bool;

/// Whether the light shines on the origin of the floor, with a ball at some height.
fn between(
    id: Id,
    what: &str,
    light: Result<LightSource, ArgumentError>,
    ball: f64,
    (exact, says): (bool, Protocol),
    illuminates: Illuminates,
) -> Case {
    let ball = || Sphere::new(Point3::new(0.0, ball, 0.0), 0.5);
    let ours = tried(|| {
        let world = world(light?)?.with(ball()?, Box::new(Lambert::new(Color::WHITE)?));
        Ok(RecursiveTracer::new(&world).trace(&look(), 1).r > 0.25)
    });
    let theirs = tried(|| {
        let world = World::new(Color::BLACK)?.with(floor()?, ());
        Ok(illuminates(LAMP, Point3::ORIGIN, &world.with(ball()?, ())))
    });
    Case::new(id, format!("{what}: lit"), exact, Equal, ours).protocol(says, theirs)
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let n = effort.choose(2_000, 20_000);
    let ball = |radius: f64| format!("ball of radius {radius} on a slope, {n} points under it: lit");
    let height = |y| Point3::new(0.0, y, 0.0);
    let in_the_floor = Point3::new(3.0, 0.0, 0.0);
    let theirs = |y| 0.25 + lambert(UP, height(y), Point3::ORIGIN);
    let point = || point_light(LAMP);
    let spot = || Ok(LightSource::new(SpotLight::new(Color::WHITE, LAMP, DOWN, 0.5)?, true));
    vec![
        brightness("I01", "light at the point itself", height(0.0), 0.25).protocol(Fails, theirs(0.0)),
        brightness("I02", "light 1e-9 above the floor", height(1e-9), 1.25).protocol(Holds, theirs(1e-9)),
        brightness("I03", "light in the floor", in_the_floor, 0.25),
        brightness("I04", "light behind the floor", height(-3.0), 0.25),
        shadow_rays("I26", "light in the floor", in_the_floor),
        shadow_rays("I14", "light behind the floor", height(-3.0)),
        between("I15", "point light, ball in between", point(), 2.0, (false, Holds), point_light_illuminates),
        between("I16", "point light, ball behind it", point(), 6.0, (true, Fails), point_light_illuminates),
        between("I17", "spot light, ball in between", spot(), 2.0, (false, Fails), spot_light_illuminates),
        between("I18", "spot light, ball under the floor", spot(), -2.0, (true, Fails), spot_light_illuminates),
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

    /// Of some points around the origin, computed as hits of rays, so that they lie a little
    /// above the slope or below, the number that is not `lit` as it should be: by our shadow
    /// rays, and by the protocol's.
    fn misjudged(
        &self,
        points: usize,
        (world, light, lit): (&World<()>, &dyn Light, bool),
        theirs: impl Fn(Point3) -> bool,
    ) -> Counts {
        wrong(0..points, |i| {
            let aside = self.normal.cross(Numbers::new(14, i).triple(-1.0, 1.0));
            let eye = self.above(3.0) + self.normal.cross(aside) * (4.0 * self.size);
            let target = Point3::ORIGIN + aside * (0.3 * self.size);
            let ray = Ray::new(eye, target - eye)?;
            let Some(hit) = self.floor.hit(&ray, Interval::AHEAD) else {
                return Ok([false; 2]);
            };
            let point = ray.at(hit.t);
            let light = light.illumination(point);
            let ours = light.is_some_and(|light| !is_shadowed(world, &ray, &hit, &light));
            Ok([ours != lit, theirs(point) != lit])
        })
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
    slope.misjudged(count, (&world, &lamp, true), |point| {
        point_light_illuminates(at, point, &world)
    })
}

/// A ball on the floor, with a lamp straight above: the points below are dark.
fn under_a_ball(count: usize, size: f64) -> Counts {
    let slope = Slope::new(size)?;
    let at = slope.above(5.0);
    let lamp = PointLight::new(Color::WHITE, at)?;
    let world = slope.world(Sphere::new(slope.above(0.5), 0.5 * size)?)?;
    slope.misjudged(count, (&world, &lamp, false), |point| {
        point_light_illuminates(at, point, &world)
    })
}

/// An empty floor under a far light: all points are lit.
fn under_the_sun(count: usize) -> Counts {
    let slope = Slope::new(1.0)?;
    let direction = Vector3::new(0.1, -1.0, -0.4).unit("direction")?;
    let sun = DirectionalLight::new(Color::WHITE, direction)?;
    let world = World::new(Color::BLACK)?.with(slope.floor, ());
    slope.misjudged(count, (&world, &sun, true), |point| {
        directional_light_illuminates(direction, point, &world)
    })
}
