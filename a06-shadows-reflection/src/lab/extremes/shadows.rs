//! Lights in unusual positions, and the protocol's shadow rays.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Plane, Sphere, World};
use a05_lighting::{Lambert, PointLight, SpotLight};
use common::{ArgumentError, Color, Error};
use measure::extremes::{Case, Equal, Fails, Holds, Id, Protocol, tried};

use super::mirrors::Counting;
use crate::protocol::{lambert, point_light_illuminates, spot_light_illuminates};
use crate::{LightSource, RecursiveTracer, ShadowedWorld};

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);
/// Position of the lights that a ball may hide.
const LAMP: Point3 = Point3::new(0.0, 4.0, 0.0);

fn floor() -> Result<Plane, ArgumentError> {
    Plane::new(Point3::ORIGIN, UP)
}

/// A white floor, ambient light of 1/4, and one more light.
fn world(floor: impl Geometry + 'static, light: LightSource) -> Result<ShadowedWorld, Error> {
    let world = ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?;
    Ok(world
        .with(floor, Box::new(Lambert::new(Color::WHITE)?))
        .lit_by(light))
}

fn point_light(position: Point3) -> Result<LightSource, ArgumentError> {
    let light = PointLight::new(Color::WHITE, position)?;
    Ok(LightSource::new(light, true))
}

/// The colour of the floor at the origin, seen from straight above.
fn brightness(id: Id, what: &str, light: Point3, exact: f64) -> Case {
    let ours = tried(|| {
        let ray = Ray::derived(Point3::new(0.0, 1.0, 0.0), DOWN);
        let world = world(floor()?, point_light(light)?)?;
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
        let rays = Arc::default();
        let floor = Counting(floor()?, Arc::clone(&rays));
        let world = world(floor, point_light(light)?)?;
        let _ = RecursiveTracer::new(&world).trace(&look(), 1);
        Ok(rays.load(Ordering::Relaxed) - 1)
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
        let world = world(floor()?, light?)?.with(ball()?, Box::new(Lambert::new(Color::WHITE)?));
        Ok(RecursiveTracer::new(&world).trace(&look(), 1).r > 0.25)
    });
    let theirs = tried(|| {
        let world = World::new(Color::BLACK)?.with(floor()?, ());
        Ok(illuminates(LAMP, Point3::ORIGIN, &world.with(ball()?, ())))
    });
    Case::new(id, format!("{what}: lit"), exact, Equal, ours).protocol(says, theirs)
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
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
    ]
}
