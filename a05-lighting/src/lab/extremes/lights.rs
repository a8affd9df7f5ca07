//! Far lights, lights inside of objects, and lights without a position.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::support::Numbers;
use a04_intersections::{Geometry, Plane, Sphere};
use common::{ArgumentError, Color};
use measure::extremes::{Absolute, Case, Equal, Fails, Holds, Id, Outcome, Refused, Ulps, tried};

use crate::lab::protocol;
use crate::{DirectionalLight, Lambert, Light, LitWorld, PointLight};

/// White light from a height above the origin.
fn lamp(y: f64) -> Result<PointLight, ArgumentError> {
    PointLight::new(Color::WHITE, Point3::new(0.0, y, 0.0))
}

/// A white shape with a light, and ambient light of 1/4.
fn world(shape: impl Geometry, light: impl Light) -> Result<LitWorld, ArgumentError> {
    let white = Box::new(Lambert::new(Color::WHITE)?);
    let world = LitWorld::new(Color::BLACK, Color::gray(0.25))?;
    Ok(world.with(shape, white).lit_by(Box::new(light)))
}

/// The unit sphere with a light at its centre.
fn light_inside() -> Result<LitWorld, ArgumentError> {
    world(Sphere::new(Point3::ORIGIN, 1.0)?, lamp(0.0)?)
}

/// Brightness of the sphere, seen from the distance `z`. The protocol's normal points
/// to the eye.
fn sphere(id: Id, what: &str, z: f64, exact: f64) -> Case {
    let ray = Ray::derived(Point3::new(0.0, 0.0, z), Vector3::new(0.0, 0.0, -1.0));
    let ours = light_inside().map(|world| world.color_for(&ray).r);
    let what = format!("light in the centre of a sphere {what}: brightness");
    let (side, says) = if z > 1.0 { (1.0, Holds) } else { (-1.0, Fails) };
    let normal = Vector3::new(0.0, 0.0, side);
    let theirs = protocol::lambert(normal.as_normal(), Point3::ORIGIN, Point3::ORIGIN + normal);
    Case::new(id, what, exact, Absolute(4.0 * f64::EPSILON), ours).protocol(says, 0.25 + theirs)
}

/// The brightness of a white wall at the origin, seen from straight before it.
fn brightness(n: Normal3, light: Result<impl Light, ArgumentError>) -> Outcome {
    tried(|| {
        let world = world(Plane::new(Point3::ORIGIN, n)?, light?)?;
        let n = Vector3::from(n);
        Ok(world.color_for(&Ray::derived(Point3::ORIGIN + n, -n)).r)
    })
}

#[rustfmt::skip]
pub fn cases() -> Vec<Case> {
    let (up, wall) = (Normal3::new(0.0, 1.0, 0.0), Normal3::new(1.0, 0.0, 0.0));
    let theirs = |y| protocol::lambert(up, Point3::new(0.0, y, 0.0), Point3::ORIGIN);
    let sun = |x, y| DirectionalLight::new(Color::WHITE, Vector3::new(x, y, 0.0));
    let from_inside = (0..1000).map(|i| off_inside(i).unwrap_or(f64::NAN));
    let nan = PointLight::new(Color::gray(f64::NAN), Point3::ORIGIN);
    vec![
        sphere("I05", "seen from outside", 3.0, 0.25),
        sphere("I06", "seen from inside", 0.5, 1.25),
        Case::new("I19", "the same from 1000 eyes inside: greatest error", 0.0, Absolute(4.0 * f64::EPSILON),
            from_inside.fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })),
        Case::new("I07", "point light at 1e200", Refused, Equal, lamp(1e200).map(|_| true))
            .protocol(Fails, theirs(1e200)),
        Case::new("I20", "point light at 1e100: brightness below", 1.25, Ulps(1.0), brightness(up, lamp(1e100)))
            .protocol(Holds, 0.25 + theirs(1e100)),
        Case::new("I21", "point light at 1e-100: brightness below", 1.25, Ulps(1.0), brightness(up, lamp(1e-100)))
            .protocol(Holds, 0.25 + theirs(1e-100)),
        Case::new("I22", "directional light at the origin: lit", true, Equal,
            sun(0.0, -1.0).map(|light| light.illuminates(Point3::ORIGIN)))
            .protocol(Fails, protocol::directional_light_illuminates(Point3::ORIGIN, Point3::ORIGIN)),
        Case::new("I23", "directional light at a wall: brightness", 1.25, Equal, brightness(wall, sun(-1.0, 0.0)))
            .protocol(Fails, 0.25 + wall.dot(protocol::DIRECTIONAL_LIGHT_FROM).max(0.0)),
        Case::new("I24", "directional light of direction 0", Refused, Equal, sun(0.0, 0.0).map(|_| true)),
        Case::new("I25", "point light of colour NaN", Refused, Equal, nan.map(|_| true)),
    ]
}

/// The error of the sphere's brightness, seen from inside; for one of many directions.
fn off_inside(i: usize) -> Result<f64, ArgumentError> {
    let mut numbers = Numbers::new(6, i);
    let mut vector = || numbers.triple(-0.5, 0.5);
    let ray = Ray::new(Point3::ORIGIN + vector(), vector())?;
    Ok((light_inside()?.color_for(&ray).r - 1.25).abs())
}
