//! The workbench: cameras and pictures that are no part of an answer's design.

use crate::functions::{self, *};

pub const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);
pub const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// A camera with this full vertical field of view.
pub fn perspective(eye: Point3, gaze: Vector3, angle: f64) -> Result<Box<dyn Camera>, Error> {
    Ok(Box::new(PerspectiveCamera::new(eye, gaze, UP, angle)?))
}

/// A camera with parallel rays, whose picture is `scale` high.
pub fn parallel(eye: Point3, gaze: Vector3, scale: f64) -> Result<Box<dyn Camera>, Error> {
    Ok(Box::new(OrthographicCamera::new(eye, gaze, UP, scale)?))
}

pub fn size([width, height]: [u32; 2]) -> Result<Size, Error> {
    Ok(Size::new(width, height)?)
}

/// A picture with one ray through the middle of each pixel.
pub fn picture(
    camera: &dyn Camera,
    pixels: [u32; 2],
    color: impl Fn(&Ray) -> Color + Sync,
) -> Result<Image, Error> {
    let settings = Settings {
        size: size(pixels)?,
        ..Settings::default()
    };
    functions::render(camera, color, &settings, &())
}

/// A picture with a ray in each cell of a grid over the pixel.
pub fn sampled_picture(
    camera: &dyn Camera,
    pixels: [u32; 2],
    samples: u32,
    color: impl Fn(&Ray) -> Color + Sync,
) -> Result<Image, Error> {
    let settings = Settings {
        size: size(pixels)?,
        samples,
        sampling: Sampling::Stratified,
        seed: crate::seed(),
        ..Settings::default()
    };
    functions::render(camera, color, &settings, &())
}

/// The picture as screens show it, by a curve from light to bytes.
pub fn for_screens(image: Image, curve: Transfer) -> Image {
    image.map(|color| color.map(|light| curve.encode(light.min(1.0))))
}

/// White where something is so.
pub fn white_if(is_so: bool) -> Color {
    if is_so { Color::WHITE } else { Color::BLACK }
}
