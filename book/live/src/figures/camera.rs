//! A camera: its axes, the rays through the corners of its picture, and the picture.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{
    Camera, OrthographicCamera, PerspectiveCamera, PinholeCamera, Ray, Sampler, StripeRule,
    StripedSky, render,
};
use a05_lighting::scenes::phong;
use common::{Sampling, Settings, Size};

use super::{Answered, gaze};
use crate::picture::pixels;

/// The steps of the page that are not the perspective camera with one ray per pixel before
/// the scene `phong`.
const ORTHOGRAPHIC: f64 = 2.0;
const SKY: f64 = 4.0;
const SAMPLES: f64 = 5.0;

/// Numbers: the eye, the gaze as angles around the vertical and upwards, the angle of
/// the up vector around the gaze of the world, and the field of view, in degrees; the step.
/// The corners are the directions of rays, each with its origin; the samples are the
/// directions through a pixel of a quarter of the picture.
pub fn answer([x, y, z, around, upwards, roll, opening, step]: [f64; 8]) -> Answered {
    let [around, upwards, roll, opening] = [around, upwards, roll, opening].map(f64::to_radians);
    let e = Point3::new(x, y, z);
    let gaze = gaze(around, upwards);
    let right = Vector3::new(libm::cos(around), 0.0, -libm::sin(around));
    let up = Vector3::new(0.0, libm::cos(roll), 0.0) + right * libm::sin(roll);
    let perspective = PerspectiveCamera::new(e, gaze, up, opening)?;
    let basis = perspective.basis();
    let camera: Box<dyn Camera> = if step == ORTHOGRAPHIC {
        let height = 5.0 * libm::tan(opening / 2.0);
        Box::new(OrthographicCamera::new(e, gaze, up, height)?)
    } else {
        Box::new(perspective)
    };

    let settings = Settings {
        size: Size::new(240, 180)?,
        samples: if step == SAMPLES { 16 } else { 1 },
        sampling: Sampling::Stratified,
        ..Settings::default()
    };
    let size = settings.size;
    let pinhole = PinholeCamera::new(Point3::ORIGIN, opening)?;
    let sky = StripedSky::new(&pinhole, size, 10, StripeRule::Direction)?;
    let world = phong()?.world;
    let radiance = |ray: &Ray| match step {
        SKY => sky.color_for(ray),
        _ => world.color_for(ray),
    };
    let image = render(&camera, radiance, &settings, &())?;

    let ends = [(-0.5, -0.5), (239.5, -0.5), (239.5, 179.5), (-0.5, 179.5)];
    let corners = ends.map(|(x, y)| camera.ray_for(size, x, y));
    let places = Sampler::new(&settings).places(0, 0);
    let samples = places.map(|(x, y)| camera.ray_for(size, 90.0 + 60.0 * x, 67.0 + 45.0 * y));
    let list = |v: Vector3| v.to_glam().to_array();
    Ok(pixels(&image)
        .with("u", list(basis.u))
        .with("v", list(basis.v))
        .with("w", list(basis.w))
        .with("gaze", list(gaze))
        .with("up", list(up))
        .with(
            "origins",
            corners
                .iter()
                .flat_map(|ray| list(ray.origin() - Point3::ORIGIN)),
        )
        .with(
            "corners",
            corners.iter().flat_map(|ray| list(ray.direction())),
        )
        .with("samples", samples.flat_map(|ray| list(ray.direction()))))
}
