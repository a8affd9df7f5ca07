//! Far lights, lights inside of objects, and lights without a position.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Plane, Sphere};
use common::{ArgumentError, Color};
use measure::extremes::Protocol::{Fails, Holds};
use measure::extremes::{Bound, Case, Outcome};

use crate::{DirectionalLight, Lambert, Light, LitWorld, PointLight, protocol};

type Made<T> = Result<T, ArgumentError>;

pub fn cases() -> Vec<Case> {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let above = |y| Point3::new(0.0, y, 0.0);
    vec![
        sphere("I05", "seen from outside", 3.0, 0.25).protocol(
            Holds,
            0.25 + protocol::lambert(
                Normal3::new(0.0, 0.0, 1.0),
                Point3::ORIGIN,
                Point3::new(0.0, 0.0, 1.0),
            ),
        ),
        sphere("I06", "seen from inside", 0.5, 1.25).protocol(
            Fails,
            0.25 + protocol::lambert(
                Normal3::new(0.0, 0.0, -1.0),
                Point3::ORIGIN,
                Point3::new(0.0, 0.0, -1.0),
            ),
        ),
        from_inside("I19", 1_000),
        Case::new(
            "I07",
            "point light at 1e200",
            Outcome::Refused,
            Bound::Equal,
            PointLight::new(Color::WHITE, above(1e200)).map(|_| true),
        )
        .protocol(Fails, protocol::lambert(up, above(1e200), Point3::ORIGIN)),
        floor(
            "I20",
            "point light at 1e100",
            PointLight::new(Color::WHITE, above(1e100)),
            1.25,
        )
        .protocol(
            Holds,
            0.25 + protocol::lambert(up, above(1e100), Point3::ORIGIN),
        ),
        floor(
            "I21",
            "point light at 1e-100",
            PointLight::new(Color::WHITE, above(1e-100)),
            1.25,
        )
        .protocol(
            Holds,
            0.25 + protocol::lambert(up, above(1e-100), Point3::ORIGIN),
        ),
        directional("I22"),
        from_the_side("I23"),
        Case::new(
            "I24",
            "directional light of direction 0",
            Outcome::Refused,
            Bound::Equal,
            DirectionalLight::new(Color::WHITE, Vector3::default()).map(|_| true),
        ),
        Case::new(
            "I25",
            "point light of colour NaN",
            Outcome::Refused,
            Bound::Equal,
            PointLight::new(Color::gray(f64::NAN), Point3::ORIGIN).map(|_| true),
        ),
    ]
}

/// The white unit sphere with a light at its centre, and ambient light of 1/4.
fn light_inside() -> Made<LitWorld> {
    let light = PointLight::new(Color::WHITE, Point3::ORIGIN)?;
    Ok(LitWorld::new(Color::BLACK, Color::gray(0.25))?
        .with(
            Sphere::new(Point3::ORIGIN, 1.0)?,
            Box::new(Lambert::new(Color::WHITE)?),
        )
        .lit_by(Box::new(light)))
}

/// Brightness of the sphere, seen from the distance `z`.
fn sphere(id: &'static str, what: &str, z: f64, exact: f64) -> Case {
    let ray = Ray::derived(Point3::new(0.0, 0.0, z), Vector3::new(0.0, 0.0, -1.0));
    let ours = light_inside().map(|world| world.color_for(&ray).r);
    let what = format!("light in the centre of a sphere {what}: brightness");
    Case::new(id, what, exact, Bound::Absolute(4.0 * f64::EPSILON), ours)
}

/// Brightness of the sphere, seen from inside; the worst of many directions.
fn from_inside(id: &'static str, count: u32) -> Case {
    let worst = || {
        let world = light_inside()?;
        (0..count).try_fold(0.0, |worst: f64, i| {
            let random = PixelRandom::new(6, i, 0);
            let number = |n| random.uniform(n) - 0.5;
            let eye = Point3::new(number(0), number(1), number(2));
            let ray = Ray::new(eye, Vector3::new(number(3), number(4), number(5)))?;
            let off = (world.color_for(&ray).r - 1.25).abs();
            Ok::<_, ArgumentError>(if off > worst || off.is_nan() {
                off
            } else {
                worst
            })
        })
    };
    let what = format!("the same from {count} eyes inside: greatest error");
    Case::new(id, what, 0.0, Bound::Absolute(4.0 * f64::EPSILON), worst())
}

/// The brightness of a white floor at the origin, seen from straight above.
fn floor<L: Light + 'static>(id: &'static str, what: &str, light: Made<L>, exact: f64) -> Case {
    let ours = brightness(Normal3::new(0.0, 1.0, 0.0), light);
    Case::new(
        id,
        format!("{what}: brightness below"),
        exact,
        Bound::Ulps(1.0),
        ours,
    )
}

fn brightness<L: Light + 'static>(n: Normal3, light: Made<L>) -> Made<f64> {
    let world = LitWorld::new(Color::BLACK, Color::gray(0.25))?
        .with(
            Plane::new(Point3::ORIGIN, n)?,
            Box::new(Lambert::new(Color::WHITE)?),
        )
        .lit_by(Box::new(light?));
    let n = Vector3::from(n);
    Ok(world.color_for(&Ray::derived(Point3::ORIGIN + n, -n)).r)
}

/// A directional light is the same at the origin as everywhere.
fn directional(id: &'static str) -> Case {
    let ours = DirectionalLight::new(Color::WHITE, Vector3::new(0.0, -1.0, 0.0))
        .map(|light| light.illuminates(Point3::ORIGIN));
    Case::new(
        id,
        "directional light at the origin: lit",
        true,
        Bound::Equal,
        ours,
    )
    .protocol(
        Fails,
        protocol::directional_light_illuminates(Point3::ORIGIN, Point3::ORIGIN),
    )
}

/// A wall with a light perpendicular to it.
fn from_the_side(id: &'static str) -> Case {
    use a02_math::Direction;
    let wall = Normal3::new(1.0, 0.0, 0.0);
    let light = DirectionalLight::new(Color::WHITE, Vector3::new(-1.0, 0.0, 0.0));
    let theirs = 0.25 + wall.dot(protocol::DIRECTIONAL_LIGHT_FROM).max(0.0);
    Case::new(
        id,
        "directional light at a wall: brightness",
        1.25,
        Bound::Equal,
        brightness(wall, light),
    )
    .protocol(Fails, theirs)
}
