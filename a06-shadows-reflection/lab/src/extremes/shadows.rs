//! Lights in unusual positions, and the protocol's shadow rays.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::kinds::KINDS as SHAPES;
use a04_intersections::{Geometry, Interval, Plane, Sphere, World};
use a04_lab::support::Numbers;
use a05_lighting::{
    DirectionalLight, Lambert, Light, PointLight, SpotLight, instruments::recorded,
};
use common::steps::{self, StepKind};
use common::{ArgumentError, Color, Error};
use measure::Effort;
use measure::extremes::Outcome::Flag;
use measure::extremes::{Case, Equal, Fails, Holds, tried, wrong};

use crate::protocol::{
    directional_light_illuminates, lambert, point_light_illuminates, spot_light_illuminates,
};
use a06_shadows_reflection::{LightSource, RecursiveTracer, ShadowedWorld, is_shadowed};

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);
/// Position of the lights that a ball may hide.
const LAMP: Point3 = Point3::new(0.0, 4.0, 0.0);
/// A ray to the origin, past the objects above it.
const LOOK: Ray = Ray::derived(Point3::new(-3.0, 4.0, 0.0), Vector3::new(0.6, -0.8, 0.0));

/// A white floor, ambient light of 1/4, and one more light, which casts shadows.
fn world(light: Result<impl Light, ArgumentError>) -> Result<ShadowedWorld, ArgumentError> {
    let floor = Plane::new(Point3::ORIGIN, UP)?;
    let world = ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?
        .with(floor, Box::new(Lambert::new(Color::WHITE)?));
    Ok(world.lit_by(LightSource::new(light?, true)))
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let n = effort.choose(2_000, 20_000);
    let (height, in_the_floor) = (|y| Point3::new(0.0, y, 0.0), Point3::new(3.0, 0.0, 0.0));
    let lit_from = |position| world(PointLight::new(Color::WHITE, position));
    // The colour of the floor at the origin, seen from straight above.
    let brightness = |id, what: &str, light, exact: f64| {
        let ray = Ray::derived(height(1.0), DOWN);
        let ours = lit_from(light).map(|world| RecursiveTracer::new(&world).trace(&ray, 1).r);
        Case::new(id, format!("{what}: brightness below"), exact, Equal, ours)
    };
    let theirs = |y| 0.25 + lambert(UP, height(y), Point3::ORIGIN);
    // The number of rays tested against the floor, without the camera's ray.
    let shadow_rays = |id, what: &str, light| {
        let ours = tried(|| {
            let world = recorded::world(lit_from(light)?, SHAPES, |surface| surface, |(_, light)| light);
            let (_, counts) = steps::counted(|| RecursiveTracer::new(&world).trace(&LOOK, 1))?;
            Ok(counts[StepKind::Test] as f64 - 1.0)
        });
        Case::new(id, format!("{what}: shadow rays"), 0.0, Equal, ours)
    };
    // Whether the light shines on the origin of the floor, with a ball at some height.
    let between = |id, what: &str, lit: Result<ShadowedWorld, _>, y, (exact, says), illuminates: Illuminates| {
        let ball = || Sphere::new(height(y), 0.5);
        let ours = tried(|| {
            let world = lit?.with(ball()?, Box::new(Lambert::new(Color::WHITE)?));
            Ok(RecursiveTracer::new(&world).trace(&LOOK, 1).r > 0.25)
        });
        let theirs = tried(|| {
            let world = World::new(Color::BLACK)?.with(Plane::new(Point3::ORIGIN, UP)?, ());
            Ok(illuminates(LAMP, Point3::ORIGIN, &world.with(ball()?, ())))
        });
        Case::new(id, format!("{what}: lit"), Flag(exact), Equal, ours).protocol(says, theirs)
    };
    let spot = || world(SpotLight::new(Color::WHITE, LAMP, DOWN, 0.5));
    let ceiling: Object = |_, lamp| Ok(Box::new(Plane::new(lamp, Normal3::new(0.1, 1.0, 0.3))?));
    let ball: Object = |slope, _| Ok(Box::new(Sphere::new(slope.above(0.5), 0.5 * slope.size)?));
    let below = |radius: f64| format!("ball of radius {radius} on a slope, {n} points under it: lit");
    vec![
        brightness("I01", "light at the point itself", height(0.0), 0.25).protocol(Fails, theirs(0.0)),
        brightness("I02", "light 1e-9 above the floor", height(1e-9), 1.25).protocol(Holds, theirs(1e-9)),
        brightness("I03", "light in the floor", in_the_floor, 0.25),
        brightness("I04", "light behind the floor", height(-3.0), 0.25),
        shadow_rays("I26", "light in the floor", in_the_floor),
        shadow_rays("I14", "light behind the floor", height(-3.0)),
        between("I15", "point light, ball in between", lit_from(LAMP), 2.0, (false, Holds), point_light_illuminates),
        between("I16", "point light, ball behind it", lit_from(LAMP), 6.0, (true, Fails), point_light_illuminates),
        between("I17", "spot light, ball in between", spot(), 2.0, (false, Fails), spot_light_illuminates),
        between("I18", "spot light, ball under the floor", spot(), -2.0, (true, Fails), spot_light_illuminates),
        Case::wrong("I08", format!("lamp on the ceiling, {n} points below: dark"),
            under_a_lamp(n, 1.0, 4.0, true, ceiling)),
        Case::wrong("S14", below(0.5), under_a_lamp(n, 1.0, 5.0, false, ball)),
        Case::wrong("S31", below(50.0), under_a_lamp(n, 100.0, 5.0, false, ball)),
        Case::wrong("S32", format!("nothing on a slope under a far light, {n} points: dark"), under_the_sun(n)),
    ]
}

/// The protocol's function of a light.
type Illuminates = fn(Point3, Point3, &World<()>) -> bool;

/// An object between a slope and the lamp at a point above it.
type Object = fn(&Slope, Point3) -> Result<Box<dyn Geometry>, ArgumentError>;

/// The points that are judged wrongly, by us and by the protocol.
type Counts = Result<[usize; 2], Error>;

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

/// The points below a lamp at a height: all lit, or all in the shadow of an object.
fn under_a_lamp(points: usize, size: f64, height: f64, lit: bool, object: Object) -> Counts {
    let slope = Slope::new(size)?;
    let at = slope.above(height);
    let lamp = PointLight::new(Color::WHITE, at)?;
    let floor = World::new(Color::BLACK)?.with(slope.floor, ());
    let world = floor.with(object(&slope, at)?, ());
    slope.misjudged(points, (&world, &lamp, lit), |point| {
        point_light_illuminates(at, point, &world)
    })
}

/// An empty floor under a far light: all points are lit.
fn under_the_sun(points: usize) -> Counts {
    let slope = Slope::new(1.0)?;
    let direction = Vector3::new(0.1, -1.0, -0.4).unit("direction")?;
    let sun = DirectionalLight::new(Color::WHITE, direction)?;
    let world = World::new(Color::BLACK)?.with(slope.floor, ());
    slope.misjudged(points, (&world, &sun, true), |point| {
        directional_light_illuminates(direction, point, &world)
    })
}
