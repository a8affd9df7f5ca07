//! The protocol's test scenes of this stage.

use a02_math::{Normal3, Point3};
use a03_rays_cameras::View;
use a04_intersections::{AxisAlignedBox, Plane, Sphere};
use a05_lighting::{Lambert, Phong, PointLight};
use a06_shadows_reflection::{LightSource, Reflective, ShadowedWorld, diagonal_camera};
use common::{ArgumentError, Color};

use crate::{Disc, Node, Transform};

type Scene = Result<View<ShadowedWorld>, ArgumentError>;

const UPWARDS: Normal3 = Normal3::new(0.0, 1.0, 0.0);

/// A black world with a little ambient light and a lamp.
fn lit_from(
    light: Point3,
    casts_shadows: bool,
    ambient: f64,
) -> Result<ShadowedWorld, ArgumentError> {
    let light = PointLight::new(Color::WHITE, light)?;
    Ok(ShadowedWorld::empty(Color::BLACK, Color::gray(ambient))?
        .lit_by(LightSource::new(light, casts_shadows)))
}

/// A sphere, scaled to an ellipsoid.
pub fn sphere_transformation() -> Scene {
    let transform = Transform::IDENTITY.scale(6.0, 1.2, 4.0)?;
    let ellipsoid = Node::new(transform).with(Sphere::new(Point3::ORIGIN, 1.0)?);
    let material = Phong::new(Color::new(0.6, 0.0, 0.0), Color::WHITE, 64.0)?;
    let world = lit_from(Point3::new(1.0, 20.0, 20.0), false, 0.25)?;
    let world = world.with(ellipsoid, Box::new(material));
    Ok(View::new(diagonal_camera(20.0)?, world))
}

/// A box, scaled and rotated three times.
pub fn box_transformations() -> Scene {
    let transform = Transform::IDENTITY
        .scale(4.0, 1.0, 8.0)?
        .rotate_z(-20_f64.to_radians())?
        .rotate_y(-5_f64.to_radians())?
        .rotate_x(-30_f64.to_radians())?;
    let (lbf, run) = (Point3::new(-0.5, -0.5, -0.5), Point3::new(0.5, 0.5, 0.5));
    let node = Node::new(transform).with(AxisAlignedBox::new(lbf, run)?);
    let world = lit_from(Point3::new(1.0, 20.0, 20.0), false, 0.25)?;
    let world = world.with(node, Box::new(Lambert::new(Color::YELLOW)?));
    Ok(View::new(diagonal_camera(10.0)?, world))
}

/// A disc on a mirroring plane.
///
/// The protocol puts the disc into the plane. Both then have the same `t`, and
/// their order in the list decides which is visible. So the disc lies a
/// thousandth above the plane here.
pub fn disc() -> Scene {
    let half = Color::gray(0.5);
    let plane = Plane::new(Point3::ORIGIN, UPWARDS)?;
    let red = Reflective::new(Color::RED, Color::BLACK, 64.0, half)?;
    let disc = Disc::new(Point3::new(0.0, 0.001, 0.0), UPWARDS, 5.0)?;
    let green = Reflective::new(Color::GREEN, Color::WHITE, 2000.0, half)?;
    let world = lit_from(Point3::new(8.0, 8.0, 8.0), true, 0.1)?
        .with(plane, Box::new(red))
        .with(disc, Box::new(green));
    Ok(View::new(diagonal_camera(8.0)?, world))
}
