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
use measure::experiment::{Curve, ErrorBound, Errors, Experiment, Point, Times};

use a01_image_display::stage;

/// The laboratory for its program.
#[must_use]
pub fn laboratory() -> Laboratory {
    Laboratory {
        stage: stage(),
        experiments,
        extremes: |_| Vec::new(),
    }
}

fn experiments() -> Vec<Experiment<'static>> {
    vec![Experiment {
        question: "What does the test card lose as JPEG, and what does that save?",
        parameter: "quality",
        work: "bytes",
        error: "rms error of a channel",
        exact: "against the picture that was saved",
        curves: Box::new(|| curves().unwrap_or_default()),
        ..Experiment::new("save-show-image")
    }]
}

/// The qualities of JPEG that are tried.
const QUALITIES: [u8; 9] = [10, 25, 50, 75, 90, 95, 98, 99, 100];

/// JPEG at all qualities, and PNG. None if the scene cannot be rendered.
fn curves() -> Option<Vec<Curve<'static>>> {
    let picture = Rc::new(picture()?);
    let mut jpeg = Vec::new();
    for quality in QUALITIES {
        jpeg.extend(point(&picture, Format::Jpeg { quality }));
    }
    let png = Curve {
        bound: Some(ErrorBound {
            error: 0.0,
            between: 100.0..=100.0,
        }),
        ..Curve::new("PNG", point(&picture, Format::Png))
    };
    Some(vec![Curve::new("JPEG", jpeg), png])
}

fn picture() -> Option<RgbImage> {
    let stage = stage();
    let scene = stage.scene("show-image").ok()?;
    let image = scene.render(&scene.defaults, &()).ok()?;
    let (size, rgb) = (image.size(), image.to_rgb8(Transfer::Linear));
    RgbImage::from_raw(size.width(), size.height(), rgb)
}

/// The format of a picture file.
#[derive(Clone, Copy)]
enum Format {
    /// With a quality from 1 to 100.
    Jpeg {
        quality: u8,
    },
    Png,
}

/// The bytes of a picture file.
fn encoded(picture: &RgbImage, format: Format) -> ImageResult<Vec<u8>> {
    let mut bytes = Vec::new();
    match format {
        Format::Jpeg { quality } => {
            let encoder = JpegEncoder::new_with_quality(&mut bytes, quality);
            picture.write_with_encoder(encoder)?;
        }
        Format::Png => picture.write_with_encoder(PngEncoder::new(&mut bytes))?,
    }
    Ok(bytes)
}

/// The measurement of a file, which is decoded again.
fn point(picture: &Rc<RgbImage>, format: Format) -> Option<Point<'static>> {
    let bytes = encoded(picture, format).ok()?;
    let opened = image::load_from_memory(&bytes).ok()?.into_rgb8();
    let mut errors = Vec::new();
    for (saved, opened) in picture.as_raw().iter().zip(opened.as_raw()) {
        errors.push((f64::from(*saved) - f64::from(*opened)) / 255.0);
    }
    let saved = Rc::clone(picture);
    Some(Point {
        parameter: match format {
            Format::Jpeg { quality } => quality.into(),
            Format::Png => 100.0,
        },
        work: bytes.len() as f64,
        errors: Errors::of(errors),
        times: Times::of(move || encoded(&saved, format)),
    })
}
