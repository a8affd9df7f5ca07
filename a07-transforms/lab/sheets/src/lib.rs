//! What the answers share, and what is no part of their design: the functions that a student's program has, cameras,
//! pictures, and the words with which the judge starts a program.

#![allow(
    ambiguous_glob_reexports,
    reason = "what several stages have for their programs"
)]

pub mod balls;

pub use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

pub use a02_math::*;
pub use a03_rays_cameras::*;
pub use a04_intersections::*;
pub use a05_lighting::*;
pub use a06_shadows_reflection::*;
pub use a07_transforms::*;
pub use common::*;

pub const AHEAD: Vector3 = Vector3::new(0.0, 0.0, -1.0);
pub const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

/// Draws the picture that the words of the command line ask for.
pub fn run(render: impl Fn(&str, u32) -> Result<Image, Error>) -> Result<(), Error> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let [scene, "--samples", samples, "-o", file] = words[..] else {
        panic!("SCENE --samples N -o FILE, not {words:?}");
    };
    let samples = samples.parse().expect("a number of samples");
    let image = render(scene, samples)?;
    let bytes = image.to_rgb8(Transfer::Linear);
    picture_file::save_png(file.as_ref(), image.size(), &bytes)
}

/// Changes all random numbers.
pub fn seed() -> u64 {
    let seed = std::env::var("SEED").ok();
    seed.and_then(|seed| seed.parse().ok()).unwrap_or_default()
}

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
    render(camera, color, &settings, &())
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
        seed: seed(),
        ..Settings::default()
    };
    render(camera, color, &settings, &())
}

/// The picture as screens show it, by a curve from light to bytes.
pub fn for_screens(image: Image, curve: Transfer) -> Image {
    image.map(|color| color.map(|light| curve.encode(light.min(1.0))))
}

/// White where something is so.
pub fn white_if(is_so: bool) -> Color {
    if is_so { Color::WHITE } else { Color::BLACK }
}
