//! The protocol's test scenes of this stage.

use a02_math::{Normal3, Point3};
use a04_intersections::{AxisAlignedBox, Plane, Sphere};
use a05_lighting::{Lambert, PointLight};
use common::{ArgumentError, Color};
use measure::Stage;

use crate::lab::{experiments, extremes};
use crate::{LightSource, Reflective, ShadowedWorld, traced_scene};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a06-shadows-reflection",
        about: "Shadows and mirrors",
        scenes: vec![
            traced_scene("sphere", "three mirroring spheres on a mirror", EYE, |_| {
                sphere()
            })
            .reflecting(),
            traced_scene("aab", "a box and its shadow", EYE, |_| aab()),
        ],
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}

/// Where the camera is, in each coordinate.
const EYE: f64 = 8.0;

fn floor() -> Result<Plane, ArgumentError> {
    Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))
}

fn sphere() -> Result<ShadowedWorld, ArgumentError> {
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
    Ok(world)
}

fn aab() -> Result<ShadowedWorld, ArgumentError> {
    let (lbf, run) = (Point3::new(-0.5, 0.0, -0.5), Point3::new(0.5, 1.0, 0.5));
    let light = PointLight::new(Color::WHITE, Point3::new(8.0, 8.0, 0.0))?;
    Ok(ShadowedWorld::empty(Color::BLACK, Color::gray(0.25))?
        .with(floor()?, Box::new(Lambert::new(Color::gray(0.8))?))
        .with(
            AxisAlignedBox::new(lbf, run)?,
            Box::new(Lambert::new(Color::RED)?),
        )
        .lit_by(LightSource::new(light, true)))
}
