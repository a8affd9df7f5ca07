//! Decodes JPEG files.

use std::io;

use image::metadata::Orientation;
use image::{DynamicImage, GrayImage, RgbImage};
use jpeg_decoder::{Decoder, Error, PixelFormat};

use super::{ENDS_TOO_EARLY, not_supported, refused};
use crate::Size;

/// The picture of a file, and how it is to be rotated and mirrored. The error is a clause.
pub fn decode(bytes: &[u8]) -> Result<(DynamicImage, Orientation), String> {
    let mut decoder = Decoder::new(bytes);
    decoder.read_info().map_err(explain)?;
    let info = decoder.info().ok_or("it has no picture")?;
    let (width, height) = (u32::from(info.width), u32::from(info.height));
    Size::new(width, height).map_err(|error| error.to_string())?;
    let mut pixels = decoder.decode().map_err(explain)?;
    if info.pixel_format == PixelFormat::CMYK32 {
        pixels = rgb_of_cmyk(&pixels);
    }
    let picture = match info.pixel_format {
        PixelFormat::L8 => GrayImage::from_raw(width, height, pixels).map(DynamicImage::from),
        PixelFormat::L16 => return Err(not_supported("more than 8 bits per channel")),
        PixelFormat::RGB24 | PixelFormat::CMYK32 => {
            RgbImage::from_raw(width, height, pixels).map(DynamicImage::from)
        }
    };
    let orientation = decoder.exif_data().and_then(Orientation::from_exif_chunk);
    let orientation = orientation.unwrap_or(Orientation::NoTransforms);
    Ok((picture.ok_or(ENDS_TOO_EARLY)?, orientation))
}

/// Red, green and blue for cyan, magenta, yellow and black, which each absorb a fraction of them.
fn rgb_of_cmyk(cmyk: &[u8]) -> Vec<u8> {
    let mut rgb = Vec::new();
    for pixel in cmyk.chunks_exact(4) {
        for ink in &pixel[..3] {
            let through_both = u32::from(255 - ink) * u32::from(255 - pixel[3]);
            rgb.push(((through_both + 127) / 255) as u8);
        }
    }
    rgb
}

fn explain(error: Error) -> String {
    match error {
        Error::Io(error) if error.kind() == io::ErrorKind::UnexpectedEof => ENDS_TOO_EARLY.into(),
        Error::Unsupported(_) => not_supported(error),
        error => refused(error),
    }
}
