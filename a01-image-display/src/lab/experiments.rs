//! Error against bytes: the error of a picture saved as JPEG.
//!
//! PNG keeps every byte of a picture. JPEG needs fewer bytes by removing details
//! that are invisible in photographs, but visible in pictures of a ray tracer.

use std::rc::Rc;

use common::{Image, Size, Transfer};
use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageResult};
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};

use crate::stage;

/// All experiments of the stage.
#[rustfmt::skip]
pub fn experiments() -> Vec<Experiment<'static>> {
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
    let curves = move |_| {
        let Some(saved) = Picture::of(scene).map(Rc::new) else {
            return Vec::new();
        };
        let qualities = [10, 25, 50, 75, 90, 95, 98, 99, 100].map(File::Jpeg);
        let jpeg = qualities.into_iter().filter_map(|file| saved.point(file));
        let png = saved.point(File::Png);
        vec![
            Curve::new("JPEG", jpeg).with_remark(LOSES),
            Curve::new("PNG", png).with_remark("what the renderer writes"),
        ]
    };
    Experiment {
        name,
        about,
        knob: "quality",
        work: "bytes",
        error: "rms error of a channel",
        unit: Unit::Light,
        exact: "against the picture that was saved",
        seeds: &[],
        against: Axis::Work,
        curves: Box::new(curves),
    }
}

const LOSES: &str =
    "not in the renderer: even its best quality changes bytes, most of all beside edges";

#[derive(Clone, Copy)]
enum File {
    /// JPEG with a quality from 1 to 100.
    Jpeg(u8),
    Png,
}

/// Red, green and blue bytes of a picture.
struct Picture {
    size: Size,
    rgb: Vec<u8>,
}

impl Picture {
    fn of(scene: &str) -> Option<Self> {
        let stage = stage();
        let scene = stage.scene(scene).ok()?;
        let image: Image = scene.render(&scene.defaults, &()).ok()?;
        Some(Self {
            size: image.size(),
            rgb: image.to_rgb8(Transfer::Linear),
        })
    }

    fn encoded(&self, file: File) -> ImageResult<Vec<u8>> {
        let mut bytes = Vec::new();
        let (width, height) = (self.size.width(), self.size.height());
        let rgb = ExtendedColorType::Rgb8;
        match file {
            File::Jpeg(quality) => JpegEncoder::new_with_quality(&mut bytes, quality)
                .write_image(&self.rgb, width, height, rgb)?,
            File::Png => PngEncoder::new(&mut bytes).write_image(&self.rgb, width, height, rgb)?,
        }
        Ok(bytes)
    }

    /// The measurement of a file, which is decoded again.
    fn point(self: &Rc<Self>, file: File) -> Option<Point<'static>> {
        let bytes = self.encoded(file).ok()?;
        let opened = image::load_from_memory(&bytes).ok()?.into_rgb8();
        let pairs = self.rgb.iter().zip(opened.as_raw());
        let errors = pairs.map(|(a, b)| (f64::from(*a) - f64::from(*b)) / 255.0);
        let quality = match file {
            File::Jpeg(quality) => quality.into(),
            File::Png => 100.0,
        };
        let saved = Rc::clone(self);
        let run = move || saved.encoded(file).map_or(0.0, |bytes| bytes.len() as f64);
        Some(Point::new(quality, bytes.len() as f64, errors, run))
    }
}
