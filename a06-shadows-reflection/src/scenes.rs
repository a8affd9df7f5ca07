//! The protocol's test scenes of this stage.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, View};
use a04_intersections::{AxisAlignedBox, Plane, Sphere};
use a05_lighting::{Lambert, PointLight};
use common::{ArgumentError, Color};

use crate::{LightSource, Reflective, ShadowedWorld};

type Scene = Result<View<ShadowedWorld>, ArgumentError>;

/// The camera of this stage's scenes and the next one's: it looks from
/// (`eye`, `eye`, `eye`) at the origin.
pub fn diagonal_camera(eye: f64) -> Result<PerspectiveCamera, ArgumentError> {
    let e = Point3::new(eye, eye, eye);
    let (g, t) = (Vector3::new(-1.0, -1.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
    PerspectiveCamera::new(e, g, t, FRAC_PI_4)
}

/// Each coordinate of the camera's position.
const EYE: f64 = 8.0;

fn floor() -> Result<Plane, ArgumentError> {
    Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))
}

/// Three mirroring spheres on a mirror.
pub fn sphere() -> Scene {
    let half = Color::gray(0.5);
    let mirror = Reflective::new(Color::gray(0.1), Color::BLACK, 64.0, half)?;
    let light = PointLight::new(Color::WHITE, Point3::new(8.0, 8.0, 8.0))?;
    let mut world = ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?
        .with(floor()?, Box::new(mirror))
        .lit_by(LightSource::new(light, true));
    for (x, color) in [(-3.0, Color::RED), (0.0, Color::GREEN), (3.0, Color::BLUE)] {
        let sphere = Sphere::new(Point3::new(x, 1.0, 0.0), 1.0)?;
        let material = Reflective::new(color, Color::WHITE, 64.0, half)?;
        world = world.with(sphere, Box::new(material));
    }
    Ok(View::new(diagonal_camera(EYE)?, world))
}

/// A box and its shadow.
pub fn aab() -> Scene {
    let (lbf, run) = (Point3::new(-0.5, 0.0, -0.5), Point3::new(0.5, 1.0, 0.5));
    let light = PointLight::new(Color::WHITE, Point3::new(8.0, 8.0, 0.0))?;
    let world = ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?
        .with(floor()?, Box::new(Lambert::new(Color::gray(0.8))?))
        .with(
            AxisAlignedBox::new(lbf, run)?,
            Box::new(Lambert::new(Color::RED)?),
        )
        .lit_by(LightSource::new(light, true));
    Ok(View::new(diagonal_camera(EYE)?, world))
}
