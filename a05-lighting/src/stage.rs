//! The protocol's test scenes of this stage: four objects, and what they look
//! like in different materials and lights.

use std::f64::consts::{FRAC_PI_4, PI};

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, PerspectiveCamera, Sampler, render};
use a04_intersections::{AxisAlignedBox, Plane, Sphere, Triangle};
use common::{ArgumentError, Color, Renderer, Scene};
use measure::Stage;

use crate::lab::{experiments, extremes};
use crate::{
    DirectionalLight, Lambert, Light, LitWorld, Material, Phong, PointLight, SingleColor, SpotLight,
};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a05-lighting",
        about: "Lights and materials: Lambert and Phong",
        scenes: vec![
            scene("lighting-1", "four objects without light", lighting_1),
            scene("lambert", "matt, under a point light", lambert),
            scene("phong", "shiny, under a point light", phong),
            scene("phong-directional", "under a far light", phong_directional),
            scene("phong-spot", "in the cone of a spot light", phong_spot),
            scene(
                "phong-spot-ambient",
                "and a little light from everywhere",
                phong_spot_ambient,
            ),
        ],
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}

fn scene(
    name: &'static str,
    about: &'static str,
    world: fn() -> Result<LitWorld, ArgumentError>,
) -> Scene {
    let camera = || PerspectiveCamera::new(CORNER, INWARDS, UP, FRAC_PI_4);
    Scene::traced(name, about, move |settings, progress| {
        let camera = camera()?;
        let world = world()?.omitting(settings.renderer != Renderer::AllWork, camera.focus());
        render(&camera, |ray| world.color_for(ray), settings, progress)
    })
    .planned(move |settings| {
        let world = world()?.prepared(camera()?.focus());
        let plan = world.plan(Sampler::plan(settings));
        Ok(plan.without(
            "shadows and mirrors",
            "these lights and materials know none",
        ))
    })
}

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
/// Where the camera and the lights are, and where both look.
const CORNER: Point3 = Point3::new(4.0, 4.0, 4.0);
const INWARDS: Vector3 = Vector3::new(-1.0, -1.0, -1.0);

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

fn lighting_1() -> Result<LitWorld, ArgumentError> {
    objects(single_color, Color::BLACK)
}

fn lambert() -> Result<LitWorld, ArgumentError> {
    Ok(objects(matt, Color::BLACK)?.lit_by(point_light()?))
}

fn phong() -> Result<LitWorld, ArgumentError> {
    Ok(objects(shiny, Color::BLACK)?.lit_by(point_light()?))
}

fn phong_directional() -> Result<LitWorld, ArgumentError> {
    Ok(objects(shiny, Color::BLACK)?.lit_by(directional_light()?))
}

fn phong_spot() -> Result<LitWorld, ArgumentError> {
    Ok(objects(shiny, Color::BLACK)?.lit_by(spot_light()?))
}

fn phong_spot_ambient() -> Result<LitWorld, ArgumentError> {
    Ok(objects(shiny, Color::gray(0.25))?.lit_by(spot_light()?))
}
