//! The settings and the pixels of a picture, as a page and a module exchange them.

use common::{Error, Image, Renderer, Sampling, Settings, Size, Transfer, fnv1a};

use crate::Reply;

/// The place of the samples that a page gives as a number: their place in the list of all.
#[must_use]
pub fn sampling(number: f64) -> Sampling {
    let found = Sampling::ALL.get(number as usize);
    found.copied().unwrap_or_default()
}

/// The settings in the numbers of a page: width, height, samples, the number of their place,
/// seed, depth and 1 for the engine. The defaults if there are none.
///
/// # Errors
///
/// Fails if a picture cannot have this size.
pub fn settings(defaults: &Settings, numbers: &[f64]) -> Result<Settings, Error> {
    let &[width, height, samples, place, seed, depth, engine, ..] = numbers else {
        return Ok(defaults.clone());
    };
    Ok(Settings {
        size: Size::new(width as u32, height as u32)?,
        samples: samples as u32,
        sampling: sampling(place),
        seed: seed as u64,
        depth: depth as u32,
        renderer: if engine == 1.0 {
            Renderer::Engine
        } else {
            Renderer::Lesson
        },
        ..defaults.clone()
    })
}

/// The pixels, size and, as text, hash of a picture.
#[must_use]
pub fn pixels(image: &Image) -> Reply {
    let rgb = image.to_rgb8(Transfer::Linear);
    let rgba = rgb.as_chunks::<3>().0.iter();
    let (width, height) = (image.size().width(), image.size().height());
    Reply {
        pixels: rgba.flat_map(|[r, g, b]| [*r, *g, *b, 255]).collect(),
        ..Reply::text(format!("{:016x}", fnv1a(&rgb)))
    }
    .with("size", [width.into(), height.into()])
}
