//! The laboratory of stage 1: the error of a picture saved as JPEG against bytes.
//!
//! PNG keeps every byte of a picture. JPEG needs fewer bytes by removing details
//! that are invisible in photographs, but visible in pictures of a ray tracer.

use std::rc::Rc;

use common::Transfer;
use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::{ImageResult, RgbImage};
use measure::Laboratory;
use measure::experiment::{Axis, Curve, Experiment, Point};

use a01_image_display::stage;

/// The laboratory for its program.
#[must_use]
pub fn laboratory() -> Laboratory {
    Laboratory {
        stage: stage(),
        experiments,
        extremes: |_| Vec::new(),
        search: None,
    }
}

#[rustfmt::skip]
fn experiments() -> Vec<Experiment<'static>> {
    vec![
        saving("save-diagonal", "diagonal",
            "What does a picture of one line lose as JPEG, and what does that save?"),
        saving("save-painter", "painter",
            "What does a disc before a gradient lose as JPEG, and what does that save?"),
        saving("save-show-image", "show-image",
            "What does the test card lose as JPEG, and what does that save?"),
    ]
}

/// An experiment that saves the picture of a scene at all qualities.
fn saving(name: &'static str, scene: &'static str, about: &'static str) -> Experiment<'static> {
    Experiment::new(name)
        .asking(about)
        .over(Axis::Work, "quality", "bytes")
        .with_error("rms error of a channel")
        .with_exact("against the picture that was saved")
        .with_curves(move |_| {
            let Some(picture) = picture(scene).map(Rc::new) else {
                return Vec::new();
            };
            let qualities = [10, 25, 50, 75, 90, 95, 98, 99, 100].map(Some);
            let jpeg = qualities.iter().filter_map(|jpeg| point(&picture, *jpeg));
            vec![
                Curve::new("JPEG", jpeg),
                Curve::new("PNG", point(&picture, None)),
            ]
        })
}

fn picture(scene: &str) -> Option<RgbImage> {
    let stage = stage();
    let scene = stage.scene(scene).ok()?;
    let image = scene.render(&scene.defaults, &()).ok()?;
    let (size, rgb) = (image.size(), image.to_rgb8(Transfer::Linear));
    RgbImage::from_raw(size.width(), size.height(), rgb)
}

/// A picture file: JPEG with a quality from 1 to 100, or PNG.
fn encoded(picture: &RgbImage, jpeg: Option<u8>) -> ImageResult<Vec<u8>> {
    let mut bytes = Vec::new();
    match jpeg {
        Some(quality) => {
            picture.write_with_encoder(JpegEncoder::new_with_quality(&mut bytes, quality))?;
        }
        None => picture.write_with_encoder(PngEncoder::new(&mut bytes))?,
    }
    Ok(bytes)
}

/// The measurement of a file, which is decoded again.
fn point(picture: &Rc<RgbImage>, jpeg: Option<u8>) -> Option<Point<'static>> {
    let bytes = encoded(picture, jpeg).ok()?;
    let opened = image::load_from_memory(&bytes).ok()?.into_rgb8();
    let pairs = picture.as_raw().iter().zip(opened.as_raw());
    let errors = pairs.map(|(a, b)| (f64::from(*a) - f64::from(*b)) / 255.0);
    let (quality, size) = (jpeg.map_or(100.0, f64::from), bytes.len() as f64);
    let saved = Rc::clone(picture);
    Some(Point::new(quality, size, errors, move || {
        encoded(&saved, jpeg)
    }))
}
