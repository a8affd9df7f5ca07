//! The protocol's test scenes of this stage: one colour an object, no light.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{Camera, OrthographicCamera, PerspectiveCamera, Sampler, render};
use common::{ArgumentError, Color, Renderer, Scene};
use measure::Stage;

use crate::lab::experiments::experiments;
use crate::lab::extremes::cases;
use crate::{AxisAlignedBox, Plane, Sphere, Triangle, World};

/// The stage for its program.
#[must_use]
pub fn stage() -> Stage {
    Stage {
        name: "a04-intersections",
        about: "Where rays meet planes, boxes, triangles and spheres",
        scenes: vec![
            scene("scene-1", "a green plane, up to the horizon", scene_1),
            scene("scene-2", "a red sphere", scene_2),
            scene("scene-3", "a blue box, from above its corner", scene_3),
            scene("scene-4", "a magenta triangle", scene_4),
            scene("scene-5", "two red spheres, one farther away", scene_5),
            scene("scene-6", "the same without perspective", scene_6),
        ],
        experiments,
        extremes: cases,
    }
}

/// A camera and the world before it.
type View = (Box<dyn Camera>, World<Color>);

fn scene(
    name: &'static str,
    about: &'static str,
    view: fn() -> Result<View, ArgumentError>,
) -> Scene {
    Scene::traced(name, about, move |settings, progress| {
        let (camera, mut world) = view()?;
        if settings.renderer != Renderer::AllWork {
            world = world.prepared(camera.focus());
        }
        render(&camera, |ray| world.color_for(ray), settings, progress)
    })
    .planned(move |settings| {
        let (camera, world) = view()?;
        let world = world.prepared(camera.focus());
        let plan = world.plan(Sampler::plan(settings));
        Ok(plan.without("lights and mirrors", "objects have a colour, no material"))
    })
}

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);

fn perspective(e: Point3, g: Vector3) -> Result<Box<dyn Camera>, ArgumentError> {
    Ok(Box::new(PerspectiveCamera::new(e, g, UP, FRAC_PI_4)?))
}

fn scene_1() -> Result<View, ArgumentError> {
    let camera = perspective(Point3::ORIGIN, AHEAD)?;
    let plane = Plane::new(Point3::new(0.0, -1.0, 0.0), Normal3::new(0.0, 1.0, 0.0))?;
    let world = World::new(Color::BLACK)?.with(plane, Color::GREEN);
    Ok((camera, world))
}

fn scene_2() -> Result<View, ArgumentError> {
    let camera = perspective(Point3::ORIGIN, AHEAD)?;
    let sphere = Sphere::new(Point3::new(0.0, 0.0, -3.0), 0.5)?;
    let world = World::new(Color::BLACK)?.with(sphere, Color::RED);
    Ok((camera, world))
}

fn scene_3() -> Result<View, ArgumentError> {
    let camera = perspective(Point3::new(3.0, 3.0, 3.0), Vector3::new(-3.0, -3.0, -3.0))?;
    let (lbf, run) = (Point3::new(-0.5, 0.0, -0.5), Point3::new(0.5, 1.0, 0.5));
    let world = World::new(Color::BLACK)?.with(AxisAlignedBox::new(lbf, run)?, Color::BLUE);
    Ok((camera, world))
}

fn scene_4() -> Result<View, ArgumentError> {
    let camera = perspective(Point3::ORIGIN, AHEAD)?;
    let triangle = Triangle::new(
        Point3::new(-0.5, 0.5, -3.0),
        Point3::new(0.5, 0.5, -3.0),
        Point3::new(0.5, -0.5, -3.0),
    )?
    .with_normals([Normal3::new(0.0, 0.0, 1.0); 3])?;
    let world = World::new(Color::BLACK)?.with(triangle, Color::MAGENTA);
    Ok((camera, world))
}

fn scene_5() -> Result<View, ArgumentError> {
    Ok((perspective(Point3::ORIGIN, AHEAD)?, two_spheres()?))
}

fn scene_6() -> Result<View, ArgumentError> {
    let camera = OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 3.0)?;
    Ok((Box::new(camera), two_spheres()?))
}

fn two_spheres() -> Result<World<Color>, ArgumentError> {
    Ok(World::new(Color::BLACK)?
        .with(Sphere::new(Point3::new(-1.0, 0.0, -3.0), 0.5)?, Color::RED)
        .with(Sphere::new(Point3::new(1.0, 0.0, -6.0), 0.5)?, Color::RED))
}
