//! Lights in unusual positions, and the protocol's shadow rays.

use std::sync::atomic::Ordering;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Plane, Sphere, World};
use a05_lighting::{Lambert, PointLight, SpotLight};
use common::{ArgumentError, Color};
use measure::extremes::Protocol::{Fails, Holds};
use measure::extremes::{Bound, Case, Protocol};

use super::mirrors::Counting;
use crate::{LightSource, RecursiveTracer, ShadowedWorld, protocol};

type Made<T> = Result<T, ArgumentError>;

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);
const DOWN: Vector3 = Vector3::new(0.0, -1.0, 0.0);

pub fn cases() -> Vec<Case> {
    let height = |y| Point3::new(0.0, y, 0.0);
    vec![
        brightness("I01", "light at the point itself", point(height(0.0)), 0.25).protocol(
            Fails,
            0.25 + protocol::lambert(UP, height(0.0), height(0.0)),
        ),
        brightness(
            "I02",
            "light 1e-9 above the floor",
            point(height(1e-9)),
            1.25,
        )
        .protocol(
            Holds,
            0.25 + protocol::lambert(UP, height(1e-9), height(0.0)),
        ),
        brightness(
            "I03",
            "light in the floor",
            point(Point3::new(3.0, 0.0, 0.0)),
            0.25,
        ),
        brightness("I04", "light behind the floor", point(height(-3.0)), 0.25),
        rays(
            "I26",
            "light in the floor",
            point(Point3::new(3.0, 0.0, 0.0)),
        ),
        rays("I14", "light behind the floor", point(height(-3.0))),
        between(
            "I15",
            "point light, ball in between",
            point(height(4.0)),
            2.0,
            (false, Holds),
            protocol::point_light_illuminates,
        ),
        between(
            "I16",
            "point light, ball behind it",
            point(height(4.0)),
            6.0,
            (true, Fails),
            protocol::point_light_illuminates,
        ),
        between(
            "I17",
            "spot light, ball in between",
            spot(height(4.0)),
            2.0,
            (false, Fails),
            protocol::spot_light_illuminates,
        ),
        between(
            "I18",
            "spot light, ball under the floor",
            spot(height(4.0)),
            -2.0,
            (true, Fails),
            protocol::spot_light_illuminates,
        ),
    ]
}

fn point(position: Point3) -> Made<LightSource> {
    Ok(LightSource::new(
        PointLight::new(Color::WHITE, position)?,
        true,
    ))
}

fn spot(position: Point3) -> Made<LightSource> {
    let light = SpotLight::new(Color::WHITE, position, DOWN, 0.5)?;
    Ok(LightSource::new(light, true))
}

fn floor() -> Made<Plane> {
    Plane::new(Point3::ORIGIN, UP)
}

/// A white floor, ambient light of 1/4, and one more light.
fn world(floor: impl Geometry + 'static, light: LightSource) -> Made<ShadowedWorld> {
    let world = ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?;
    let white = Lambert::new(Color::WHITE)?;
    Ok(world.with(floor, Box::new(white)).lit_by(light))
}

/// A ray to the origin, past the objects above it.
fn look() -> Ray {
    Ray::derived(Point3::new(-3.0, 4.0, 0.0), Vector3::new(0.6, -0.8, 0.0))
}

/// The colour of the floor at the origin, seen from straight above.
fn brightness(id: &'static str, what: &str, light: Made<LightSource>, exact: f64) -> Case {
    let color = || {
        let world = world(floor()?, light?)?;
        let ray = Ray::derived(Point3::new(0.0, 1.0, 0.0), DOWN);
        Ok::<_, ArgumentError>(RecursiveTracer::new(&world).trace(&ray, 1).r)
    };
    Case::new(
        id,
        format!("{what}: brightness below"),
        exact,
        Bound::Equal,
        color(),
    )
}

/// Number of rays tested against the floor, without the camera's ray.
fn rays(id: &'static str, what: &str, light: Made<LightSource>) -> Case {
    let count = || {
        let (floor, rays) = Counting::new(floor()?);
        let world = world(floor, light?)?;
        let _ = RecursiveTracer::new(&world).trace(&look(), 1);
        Ok::<_, ArgumentError>(rays.load(Ordering::Relaxed) - 1)
    };
    Case::new(
        id,
        format!("{what}: shadow rays"),
        0.0,
        Bound::Equal,
        count(),
    )
}

type Illuminates = fn(Point3, Point3, &World<()>) -> bool;

/// Whether the light at (0, 4, 0) shines on the origin of the floor, with a
/// ball at some height.
fn between(
    id: &'static str,
    what: &str,
    light: Made<LightSource>,
    ball: f64,
    (exact, says): (bool, Protocol),
    illuminates: Illuminates,
) -> Case {
    let ball = || Sphere::new(Point3::new(0.0, ball, 0.0), 0.5);
    let ours = || {
        let white = Lambert::new(Color::WHITE)?;
        let world = world(floor()?, light?)?.with(ball()?, Box::new(white));
        let color = RecursiveTracer::new(&world).trace(&look(), 1);
        Ok::<_, ArgumentError>(color.r > 0.25)
    };
    let theirs = || {
        let world = World::new(Color::BLACK)?
            .with(floor()?, ())
            .with(ball()?, ());
        let light = Point3::new(0.0, 4.0, 0.0);
        Ok::<_, ArgumentError>(illuminates(light, Point3::ORIGIN, &world))
    };
    Case::new(id, format!("{what}: lit"), exact, Bound::Equal, ours()).protocol(says, theirs())
}
