//! Lights near and far, inside of objects, and without a position.

use a02_math::arrays::vector;
use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Plane, Sphere};
use a04_lab::support::Triple;
use common::{ArgumentError, Color};
use measure::extremes::{Case, Outcome, tried};

use crate::protocol;
use a05_lighting::{DirectionalLight, Lambert, Light, LitWorld, PointLight};

const UP: Normal3 = Normal3::new(0.0, 1.0, 0.0);

/// A white shape with a light, and ambient light of 1/4.
fn world(shape: impl Geometry, light: impl Light) -> Result<LitWorld, ArgumentError> {
    let white = Box::new(Lambert::new(Color::WHITE)?);
    let world = LitWorld::new(Color::BLACK, Color::gray(0.25))?;
    Ok(world.with(shape, white).lit_by(Box::new(light)))
}

/// The brightness of a white wall at the origin, seen from straight before it.
fn brightness(n: Normal3, light: Result<impl Light, ArgumentError>) -> Outcome {
    tried(|| {
        let world = world(Plane::new(Point3::ORIGIN, n)?, light?)?;
        let n = Vector3::from(n);
        Ok(world.color_for(&Ray::derived(Point3::ORIGIN + n, -n)).r)
    })
}

/// A point light at a height over the origin.
fn lamp(height: f64) -> Result<PointLight, ArgumentError> {
    PointLight::new(Color::WHITE, Point3::new(0.0, height, 0.0))
}

/// The brightness of the floor below such a light.
pub fn under_a_lamp(height: f64) -> Case {
    let lit = protocol::lambert(UP, Point3::new(0.0, height, 0.0), Point3::ORIGIN);
    let theirs = 0.25 + lit;
    Case::of(brightness(UP, lamp(height)), theirs)
}

fn sun(x: f64, y: f64) -> Result<DirectionalLight, ArgumentError> {
    DirectionalLight::new(Color::WHITE, Vector3::new(x, y, 0.0))
}

/// The brightness of the unit sphere, which a light in its centre lights from inside only.
fn of_the_sphere(ray: Result<Ray, ArgumentError>) -> Result<f64, ArgumentError> {
    let sphere = Sphere::new(Point3::ORIGIN, 1.0)?;
    Ok(world(sphere, lamp(0.0)?)?.color_for(&ray?).r)
}

/// The same, seen downwards from a height. The protocol's normal points to the eye.
pub fn from_height(z: f64) -> Case {
    let ray = Ray::new(Point3::new(0.0, 0.0, z), Vector3::new(0.0, 0.0, -1.0));
    let normal = Vector3::new(0.0, 0.0, if z > 1.0 { 1.0 } else { -1.0 });
    let theirs = protocol::lambert(normal.as_normal(), Point3::ORIGIN, Point3::ORIGIN + normal);
    Case::of(of_the_sphere(ray), 0.25 + theirs)
}

/// The brightness of a wall of this normal under a light from a direction.
pub fn in_the_sun(normal: Triple, x: f64, y: f64) -> Case {
    let normal = vector(normal).as_normal();
    let from_above = normal.dot(protocol::DIRECTIONAL_LIGHT_FROM).max(0.0);
    Case::of(brightness(normal, sun(x, y)), 0.25 + from_above)
}

/// Whether a directional light shines on the origin.
pub fn sun_at_the_origin() -> Case {
    Case::of(
        sun(0.0, -1.0).map(|light| light.illuminates(Point3::ORIGIN)),
        protocol::directional_light_illuminates(Point3::ORIGIN, Point3::ORIGIN),
    )
}
