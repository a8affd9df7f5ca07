//! Pictures of students' code, and vectors and colours from numbers.

use std::f64::consts::FRAC_PI_4;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{PerspectiveCamera, Ray, View, render};
use common::{ArgumentError, Color};
use measure::Stage;
use testing::exercise::{Check, Random};

pub fn point(xyz: [f64; 3]) -> Point3 {
    Point3::from_glam(xyz.into())
}

pub fn vector(xyz: [f64; 3]) -> Vector3 {
    Vector3::from_glam(xyz.into())
}

/// The direction of length 1; all zeros where there is none.
pub fn unit(xyz: [f64; 3]) -> Vector3 {
    vector(xyz).normalized().unwrap_or_default()
}

pub fn array(v: Vector3) -> [f64; 3] {
    v.to_glam().to_array()
}

pub fn color([r, g, b]: [f64; 3]) -> Color {
    Color::new(r, g, b)
}

/// The channels of a random colour.
pub fn channels(random: &mut Random) -> [f64; 3] {
    [(); 3].map(|()| random.between(0.0, 1.5))
}

/// A scene of a stage: the camera and the world before it.
pub type Scene<W> = Result<View<W>, ArgumentError>;

/// Compares the picture of a scene in the colours of this function, which takes the world, a
/// ray and the depth.
pub fn scene<W: Sync>(
    check: &mut Check,
    stage: &Stage,
    name: &str,
    view: Scene<W>,
    color: impl Fn(&W, &Ray, u32) -> Color + Sync,
) {
    check.scene(stage, name, |settings| {
        let View { camera, world } = view?;
        let color = |ray: &Ray| color(&world, ray, settings.depth);
        render(&camera, color, settings, &())
    });
}

/// Shows the colours of the rays from an eye that looks at the point `at` of a world.
pub fn show<W: Sync>(
    check: &mut Check,
    [eye, at]: [[f64; 3]; 2],
    world: Result<W, ArgumentError>,
    color: impl Fn(&W, &Ray) -> Color + Sync,
) {
    check.picture(|settings| {
        let (world, up) = (world?, Vector3::new(0.0, 1.0, 0.0));
        let camera = PerspectiveCamera::new(point(eye), point(at) - point(eye), up, FRAC_PI_4)?;
        render(&camera, |ray: &Ray| color(&world, ray), settings, &())
    });
}
