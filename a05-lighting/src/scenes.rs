//! The protocol's test scenes of this stage: four objects in
//! different materials and lights.

use std::f64::consts::{FRAC_PI_4, PI};

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, View};
use a04_intersections::{AxisAlignedBox, Plane, Sphere, Triangle};
use common::{ArgumentError, Color};

use crate::{
    DirectionalLight, Lambert, Light, LitWorld, Material, Phong, PointLight, SingleColor, SpotLight,
};

type Scene = Result<View<LitWorld>, ArgumentError>;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
/// Position of the camera and of the lights, and the point that both aim at.
const CORNER: Point3 = Point3::new(4.0, 4.0, 4.0);
const INWARDS: Vector3 = Vector3::new(-1.0, -1.0, -1.0);

/// The camera of all six scenes, and the world before it.
fn view(world: LitWorld) -> Scene {
    let camera = PerspectiveCamera::new(CORNER, INWARDS, UP, FRAC_PI_4)?;
    Ok(View::new(camera, world))
}

type MaterialOf = fn(Color) -> Result<Box<dyn Material>, ArgumentError>;

fn single_color(color: Color) -> Result<Box<dyn Material>, ArgumentError> {
    Ok(Box::new(SingleColor::new(color)?))
}

fn matt(color: Color) -> Result<Box<dyn Material>, ArgumentError> {
    Ok(Box::new(Lambert::new(color)?))
}

fn shiny(color: Color) -> Result<Box<dyn Material>, ArgumentError> {
    Ok(Box::new(Phong::new(color, Color::WHITE, 64.0)?))
}

/// The four objects of all six scenes.
fn objects(material: MaterialOf, ambient: Color) -> Result<LitWorld, ArgumentError> {
    let plane = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let sphere = Sphere::new(Point3::new(1.0, 1.0, 1.0), 0.5)?;
    let (lbf, run) = (Point3::new(-1.5, 0.5, 0.5), Point3::new(-0.5, 1.5, 1.5));
    let aab = AxisAlignedBox::new(lbf, run)?;
    let triangle = Triangle::new(
        Point3::new(0.0, 0.0, -1.0),
        Point3::new(1.0, 0.0, -1.0),
        Point3::new(1.0, 1.0, -1.0),
    )?;
    Ok(LitWorld::new(Color::BLACK, ambient)?
        .with(plane, material(Color::RED)?)
        .with(sphere, material(Color::GREEN)?)
        .with(aab, material(Color::BLUE)?)
        .with(triangle, material(Color::YELLOW)?))
}

fn point_light() -> Result<Box<dyn Light>, ArgumentError> {
    Ok(Box::new(PointLight::new(Color::WHITE, CORNER)?))
}

fn directional_light() -> Result<Box<dyn Light>, ArgumentError> {
    Ok(Box::new(DirectionalLight::new(Color::WHITE, INWARDS)?))
}

fn spot_light() -> Result<Box<dyn Light>, ArgumentError> {
    let spot = SpotLight::new(Color::WHITE, CORNER, INWARDS, PI / 14.0)?;
    Ok(Box::new(spot))
}

/// Four objects without light.
pub fn lighting_1() -> Scene {
    view(objects(single_color, Color::BLACK)?)
}

/// Matt objects under a point light.
pub fn lambert() -> Scene {
    view(objects(matt, Color::BLACK)?.lit_by(point_light()?))
}

/// Shiny objects under a point light.
pub fn phong() -> Scene {
    view(objects(shiny, Color::BLACK)?.lit_by(point_light()?))
}

/// Shiny objects under a far light.
pub fn phong_directional() -> Scene {
    view(objects(shiny, Color::BLACK)?.lit_by(directional_light()?))
}

/// Shiny objects in the cone of a spot light.
pub fn phong_spot() -> Scene {
    view(objects(shiny, Color::BLACK)?.lit_by(spot_light()?))
}

/// The scene `phong_spot` with a little ambient light.
pub fn phong_spot_ambient() -> Scene {
    view(objects(shiny, Color::gray(0.25))?.lit_by(spot_light()?))
}
