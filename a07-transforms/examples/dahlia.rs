//! The picture at the top of the README: a dahlia of transformed spheres on a mirror.
//! Takes the arguments of the stages' programs.

use std::f64::consts::{PI, TAU};
use std::process::ExitCode;

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, View, traced_scene};
use a04_intersections::{Plane, Sphere};
use a05_lighting::PointLight;
use a06_shadows_reflection::{LightSource, Reflective, ShadowedWorld};
use a07_transforms::{Node, Transform, traced};
use common::{ArgumentError, Color, Renderer, Sampling, Settings, Size, Stage, Transfer};

fn main() -> ExitCode {
    command_line::run(&stage(), a01_image_display::viewer())
}

/// The picture as a stage, so that its program can show and its test lock it. The engine
/// renders it by default, because the lesson tests every ray against every petal.
#[must_use]
pub fn stage() -> Stage {
    let view = |_| dahlia().map(traced);
    let defaults = Settings {
        transfer: Transfer::Srgb,
        size: Size::new(960, 640).unwrap_or(Size::COURSE),
        samples: 16,
        sampling: Sampling::Stratified,
        renderer: Renderer::Engine,
        ..Settings::default()
    };
    let scene = traced_scene("dahlia", "a dahlia on a mirror", view).reflecting();
    Stage {
        name: "showpiece",
        about: "A dahlia of transformed spheres on a mirror",
        scenes: vec![scene.with_defaults(defaults)],
        open: None,
    }
}

/// Number of petals.
const PETALS: u32 = 220;

/// The golden angle, by which the leaves of many plants follow one another (Vogel: A
/// Better Way to Construct the Sunflower Head, 1979).
const GOLDEN_ANGLE: f64 = PI * 0.763_932_022_500_210_3;

/// The flower, dew drops, and two lamps.
pub fn dahlia() -> Result<View<ShadowedWorld>, ArgumentError> {
    let (warm, cold) = (Color::new(1.0, 0.93, 0.82), Color::new(0.25, 0.35, 0.6));
    let warm = PointLight::new(warm * 0.85, Point3::new(3.5, 9.0, 7.0))?;
    let cold = PointLight::new(cold, Point3::new(-8.0, 4.0, -1.0))?;
    let (deep, mirrored) = (Color::new(0.01, 0.015, 0.03), Color::new(0.32, 0.36, 0.42));
    let water = Reflective::new(deep, Color::BLACK, 1.0, mirrored)?;
    let plane = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    let mut world = ShadowedWorld::empty(Color::new(0.012, 0.018, 0.035), Color::gray(0.14))?
        .lit_by(LightSource::new(warm, true))
        .lit_by(LightSource::new(cold, true))
        .with(plane, Box::new(water));
    for n in 0..PETALS {
        let fraction = libm::sqrt(f64::from(n) / f64::from(PETALS - 1));
        let (petal, surface) = petal(f64::from(n), fraction)?;
        world = world.with(petal, Box::new(surface));
    }
    for (x, z, r) in [
        (2.5, 1.7, 0.32),
        (-2.55, 1.5, 0.26),
        (-3.2, -1.6, 0.5),
        (3.3, -1.9, 0.4),
        (0.55, 2.75, 0.16),
    ] {
        let drop = Sphere::new(Point3::new(x, r, z), r)?;
        let silver = Reflective::new(Color::gray(0.03), Color::WHITE, 400.0, Color::gray(0.85))?;
        world = world.with(drop, Box::new(silver));
    }
    let eye = Point3::new(0.0, 3.7, 7.6);
    let up = Vector3::new(0.0, 1.0, 0.0);
    let camera = PerspectiveCamera::new(eye, Point3::new(0.0, 0.42, 0.0) - eye, up, 0.58)?;
    Ok(View::new(camera, world))
}

/// The petal with this number and this fraction of the way from the middle, 0, to the rim,
/// 1: a flat sphere that leans outwards the more, the farther out it is.
fn petal(number: f64, fraction: f64) -> Result<(Node, Reflective), ArgumentError> {
    let (length, width) = (0.2 + 0.75 * fraction, 0.06 + 0.2 * fraction);
    let lean = (4.0 + 84.0 * fraction * fraction).to_radians();
    // ANCHOR: petal
    let transform = Transform::IDENTITY
        .translate(Point3::new(
            0.0,
            0.14 + 0.7 * (1.0 - fraction * fraction),
            0.0,
        ))?
        .rotate_y((number * GOLDEN_ANGLE) % TAU)?
        .translate(Point3::new(0.0, 0.0, 1.3 * fraction))?
        .rotate_x(lean)?
        .translate(Point3::new(0.0, length * 0.8, 0.0))?
        .scale(width, length, 0.05)?;
    // ANCHOR_END: petal
    let (inner, outer) = (Color::new(1.0, 0.62, 0.12), Color::new(0.62, 0.02, 0.16));
    let color = inner * (1.0 - fraction) + outer * fraction;
    let satin = Reflective::new(color, Color::gray(0.35), 40.0, Color::gray(0.06))?;
    let ball = Sphere::new(Point3::ORIGIN, 1.0)?;
    Ok((Node::new(transform).with(ball), satin))
}
