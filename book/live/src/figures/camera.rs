//! A camera: its axes, the rays through the corners of its picture, and the picture.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Camera, PerspectiveCamera, render};
use a05_lighting::scenes::phong;
use common::{Settings, Size};

use super::Answered;
use crate::picture::pixels;

/// Numbers: the eye, the gaze as angles around the vertical and upwards, the angle of
/// the up vector around the gaze of the world, and the opening angle; in degrees. The
/// picture shows the scene `phong`.
pub fn answer([x, y, z, around, upwards, roll, opening]: [f64; 7]) -> Answered {
    let [around, upwards, roll, opening] = [around, upwards, roll, opening].map(f64::to_radians);
    let e = Point3::new(x, y, z);
    let level = libm::cos(upwards);
    let gaze = Vector3::new(
        -libm::sin(around) * level,
        libm::sin(upwards),
        -libm::cos(around) * level,
    );
    let right = Vector3::new(libm::cos(around), 0.0, -libm::sin(around));
    let up = Vector3::new(0.0, libm::cos(roll), 0.0) + right * libm::sin(roll);
    let camera = PerspectiveCamera::new(e, gaze, up, opening)?;

    let size = Size::new(240, 180)?;
    let (last_x, last_y) = (239.5, 179.5);
    let corners = [
        (-0.5, -0.5),
        (last_x, -0.5),
        (last_x, last_y),
        (-0.5, last_y),
    ];
    let corners = corners.into_iter();
    let corners =
        corners.flat_map(|(x, y)| camera.ray_for(size, x, y).direction().to_glam().to_array());
    let basis = camera.basis();
    let [u, v, w] = [basis.u, basis.v, basis.w].map(|axis| axis.to_glam().to_array());

    let world = phong()?.world;
    let settings = Settings {
        size,
        ..Settings::default()
    };
    let image = render(&camera, |ray| world.color_for(ray), &settings, &())?;
    Ok(pixels(&image)
        .with("u", u)
        .with("v", v)
        .with("w", w)
        .with("gaze", gaze.to_glam().to_array())
        .with("up", up.to_glam().to_array())
        .with("corners", corners))
}
