//! Far lights, lights inside of objects, lights without a position, and points at the edge
//! of a cone, on its axis, and behind the light.

use std::f64::consts::PI;

use a02_math::lab::extremes::{point, vector};
use a02_math::lab::protocol::angle_by_arc_cosine;
use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::support::Numbers;
use a04_intersections::{Geometry, Plane, Sphere};
use common::{ArgumentError, Color};
use measure::Effort;
use measure::extremes::{Absolute, Case, Equal, Fails, Holds, Id, Outcome, Protocol, Refused};
use measure::extremes::{Ulps, greatest, tried};

use crate::lab::protocol;
use crate::{DirectionalLight, Lambert, Light, LitWorld, PointLight, SpotLight};

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

pub fn cases(effort: Effort) -> Vec<Case> {
    [spots(effort), others()].concat()
}

#[rustfmt::skip]
fn others() -> Vec<Case> {
    let (up, wall) = (Normal3::new(0.0, 1.0, 0.0), Normal3::new(1.0, 0.0, 0.0));
    let theirs = |y| protocol::lambert(up, Point3::new(0.0, y, 0.0), Point3::ORIGIN);
    let sun = |x, y| DirectionalLight::new(Color::WHITE, Vector3::new(x, y, 0.0));
    // The error of the sphere's brightness, seen from inside in many directions.
    let off_inside = |i| {
        let mut numbers = Numbers::new(6, i);
        let mut vector = || numbers.triple(-0.5, 0.5);
        let ray = Ray::new(Point3::ORIGIN + vector(), vector())?;
        Ok(light_inside()?.color_for(&ray).r - 1.25)
    };
    let from_inside = (0..1000).map(off_inside).map(|off: Result<_, ArgumentError>| off.unwrap_or(f64::NAN));
    let nan = PointLight::new(Color::gray(f64::NAN), Point3::ORIGIN);
    vec![
        sphere("I05", "seen from outside", 3.0, 0.25),
        sphere("I06", "seen from inside", 0.5, 1.25),
        Case::new("I19", "the same from 1000 eyes inside: greatest error", 0.0, Absolute(4.0 * f64::EPSILON),
            greatest(from_inside)),
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

/// Direction and half angle of a spot light at the origin.
type Cone = (Vector3, f64);

/// Whether a spot light shines on a point.
fn ours((direction, half_angle): Cone, point: Point3) -> Outcome {
    let light = SpotLight::new(Color::WHITE, Point3::ORIGIN, direction, half_angle);
    light.map(|light| light.illuminates(point)).into()
}

fn theirs((direction, half_angle): Cone, point: Point3) -> Outcome {
    protocol::spot_light_illuminates(Point3::ORIGIN, direction, half_angle, point).into()
}

fn spot(
    id: Id,
    what: &str,
    (direction, half_angle): ([f64; 3], f64),
    at: [f64; 3],
    exact: impl Into<Outcome>,
    says: Protocol,
) -> Case {
    let (cone, at) = ((vector(direction), half_angle), point(at));
    Case::new(
        id,
        format!("spot, {what}: lit"),
        exact,
        Equal,
        ours(cone, at),
    )
    .protocol(says, theirs(cone, at))
}

#[rustfmt::skip]
fn spots(effort: Effort) -> Vec<Case> {
    let count = effort.choose(10_000, 100_000);
    let (ones, ahead) = ([1.0; 3], [0.0, 0.0, -1.0]);
    let beside = |angle: f64| [libm::sin(angle), 0.0, -libm::cos(angle)];
    // Directions of any length below √3.
    let number = |is_counted: &dyn Fn(Vector3) -> bool| {
        let directions = (0..count).map(|i| Numbers::new(9, i).triple(-1.0, 1.0));
        directions.filter(|v| is_counted(*v)).count()
    };
    let behind = |is_lit: fn(Cone, Point3) -> Outcome|
        number(&|v| is_lit((v, 0.1), Point3::ORIGIN - v * 3.0) == true.into());
    let not_numbers = |angle: fn(Vector3, Vector3) -> f64| number(&|v| angle(v, v * 3.0).is_nan());
    let (x, diagonal) = (Vector3::new(2.0, 0.0, 0.0), Vector3::new(1.0, 1.0, 0.0));
    vec![
        spot("F06", "a point on the axis", (ones, 0.1), ones, true, Holds),
        spot("F07", "a point straight behind", (ones, 0.1), [-1.0; 3], false, Fails),
        spot("F08", "half angle 0, a point on the axis", ([1.0, 1.0, 8.0], 0.0), [1.0, 1.0, 8.0], Refused, Fails),
        spot("F09", "half angle π, a point straight behind", (ahead, PI), [0.0, 0.0, 1.0], true, Holds),
        spot("F10", "half angle 1e-9, a point at 1e-8", (ahead, 1e-9), beside(1e-8), Refused, Fails),
        spot("F11", "the position itself", (ahead, 0.1), [0.0; 3], false, Fails),
        spot("F12", "half angle NaN", (ahead, f64::NAN), ahead, Refused, Fails),
        spot("F13", "a point 1e200 away on the axis", (ahead, 0.1), [0.0, 0.0, -1e200], true, Fails),
        spot("F37", "half angle 1e-7, a point at 1.2e-7", (ahead, 1e-7), beside(1.2e-7), false, Holds),
        spot("F38", "half angle 1e-7, a point at 0.8e-7", (ahead, 1e-7), beside(0.8e-7), true, Holds),
        Case::new("I09", format!("spot, {count} points straight behind: lit"), 0.0, Equal, behind(ours))
            .protocol(Fails, behind(theirs)),
        Case::new("S15", format!("{count} angles between parallel vectors: NaN"),
            0.0, Equal, not_numbers(Vector3::angle)).protocol(Fails, not_numbers(angle_by_arc_cosine)),
        Case::new("F39", "angle between (2, 0, 0) and (1, 1, 0)", PI / 4.0, Ulps(1.0), x.angle(diagonal))
            .protocol(Fails, protocol::angle(x, diagonal)),
    ]
}
