//! The protocol's test scenes of this stage: one colour per object, no light.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{OrthographicCamera, PerspectiveCamera, View};
use common::{ArgumentError, Color};

use crate::{AxisAlignedBox, Plane, Sphere, Triangle, World};

type Scene = Result<View<World<Color>>, ArgumentError>;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);

fn perspective(e: Point3, g: Vector3) -> Result<PerspectiveCamera, ArgumentError> {
    PerspectiveCamera::new(e, g, UP, FRAC_PI_4)
}

/// A world before the camera that most scenes have.
fn view(world: World<Color>) -> Scene {
    Ok(View::new(perspective(Point3::ORIGIN, AHEAD)?, world))
}

/// A green plane, up to the horizon.
pub fn scene_1() -> Scene {
    let plane = Plane::new(Point3::new(0.0, -1.0, 0.0), Normal3::new(0.0, 1.0, 0.0))?;
    view(World::new(Color::BLACK)?.with(plane, Color::GREEN))
}

/// A red sphere.
pub fn scene_2() -> Scene {
    let sphere = Sphere::new(Point3::new(0.0, 0.0, -3.0), 0.5)?;
    view(World::new(Color::BLACK)?.with(sphere, Color::RED))
}

/// A blue box, seen from above one of its corners.
pub fn scene_3() -> Scene {
    let camera = perspective(Point3::new(3.0, 3.0, 3.0), Vector3::new(-3.0, -3.0, -3.0))?;
    let (lbf, run) = (Point3::new(-0.5, 0.0, -0.5), Point3::new(0.5, 1.0, 0.5));
    let world = World::new(Color::BLACK)?.with(AxisAlignedBox::new(lbf, run)?, Color::BLUE);
    Ok(View::new(camera, world))
}

/// A magenta triangle.
pub fn scene_4() -> Scene {
    let triangle = Triangle::new(
        Point3::new(-0.5, 0.5, -3.0),
        Point3::new(0.5, 0.5, -3.0),
        Point3::new(0.5, -0.5, -3.0),
    )?
    .with_normals([Normal3::new(0.0, 0.0, 1.0); 3])?;
    view(World::new(Color::BLACK)?.with(triangle, Color::MAGENTA))
}

/// Two red spheres, one farther away.
pub fn scene_5() -> Scene {
    view(two_spheres()?)
}

/// The two spheres of `scene_5` without perspective.
pub fn scene_6() -> Scene {
    let camera = OrthographicCamera::new(Point3::ORIGIN, AHEAD, UP, 3.0)?;
    Ok(View::new(camera, two_spheres()?))
}

fn two_spheres() -> Result<World<Color>, ArgumentError> {
    Ok(World::new(Color::BLACK)?
        .with(Sphere::new(Point3::new(-1.0, 0.0, -3.0), 0.5)?, Color::RED)
        .with(Sphere::new(Point3::new(1.0, 0.0, -6.0), 0.5)?, Color::RED))
}
