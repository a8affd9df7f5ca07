//! Decodes JPEG files.

use std::io;

use image::metadata::Orientation;
use image::{DynamicImage, GrayImage, RgbImage};
use jpeg_decoder::{ColorTransform, Decoder, Error, PixelFormat};

use super::{ENDS_TOO_EARLY, not_supported, refused};
use crate::Size;

/// The marker of the end of a picture.
const END: &[u8] = &[0xFF, 0xD9];

/// The picture of a file, and how it is to be rotated and mirrored. The error is a clause.
pub fn decode(bytes: &[u8]) -> Result<(DynamicImage, Orientation), String> {
    // The decoder would take missing data for zeros. So bits that are all 1 stand before the end: no code consists
    // of such bits alone, and of a whole picture none of them is read. Behind 0xFF, 0 says that it is no marker.
    let guarded = match bytes.strip_suffix(END) {
        Some(data) => [data, &[0xFF, 0].repeat(16), END].concat(),
        None => bytes.to_vec(),
    };
    let mut decoder = Decoder::new(guarded.as_slice());
    decoder.read_info().map_err(explain)?;
    let info = decoder.info().ok_or("it has no picture")?;
    let (width, height) = (u32::from(info.width), u32::from(info.height));
    Size::new(width, height).map_err(|error| error.to_string())?;
    let markers = Markers::read(bytes);
    if info.pixel_format == PixelFormat::RGB24 && markers.says_rgb() {
        // The decoder would ask the numbers of the components first.
        decoder.set_color_transform(ColorTransform::RGB);
    }
    let mut pixels = decoder.decode().map_err(explain)?;
    if info.pixel_format == PixelFormat::CMYK32 {
        pixels = rgb_of_cmyk(&pixels, markers.adobe.is_some());
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

/// What the markers before a picture say about its colours.
#[derive(Default)]
struct Markers {
    /// JFIF pictures are gray, or YCbCr.
    is_jfif: bool,
    /// The transform of Adobe's marker: 0 for none, 1 for YCbCr, 2 for YCCK.
    adobe: Option<u8>,
}

impl Markers {
    /// The markers up to the first scan.
    fn read(bytes: &[u8]) -> Self {
        let mut markers = Self::default();
        // Behind the marker of the beginning. The length of a segment includes its own two bytes.
        let mut rest = bytes.get(2..).unwrap_or_default();
        while let [0xFF, marker, high, low, ..] = *rest {
            let length = usize::from(u16::from_be_bytes([high, low]));
            let content = rest.get(4..2 + length).unwrap_or_default();
            match marker {
                // Fill bytes may stand before a marker.
                0xFF => {
                    rest = &rest[1..];
                    continue;
                }
                0xDA => break,
                0xE0 if content.starts_with(b"JFIF\0") => markers.is_jfif = true,
                0xEE if content.starts_with(b"Adobe") => markers.adobe = content.get(11).copied(),
                _ => {}
            }
            rest = rest.get(2 + length..).unwrap_or_default();
        }
        markers
    }

    /// Whether three components are red, green and blue, as the JPEG library of the Independent JPEG Group
    /// decides it.
    fn says_rgb(&self) -> bool {
        !self.is_jfif && self.adobe == Some(0)
    }
}

/// Red, green and blue for cyan, magenta, yellow and black, which each absorb a fraction of them. Adobe's
/// files store what is left of the light, and the decoder takes all files for Adobe's.
fn rgb_of_cmyk(cmyk: &[u8], is_adobes: bool) -> Vec<u8> {
    let mut rgb = Vec::new();
    for pixel in cmyk.chunks_exact(4) {
        let left = |ink: u8| u32::from(if is_adobes { 255 - ink } else { ink });
        for ink in &pixel[..3] {
            let through_both = left(*ink) * left(pixel[3]);
            rgb.push(((through_both + 127) / 255) as u8);
        }
    }
    rgb
}

fn explain(error: Error) -> String {
    match error {
        Error::Io(error) if error.kind() == io::ErrorKind::UnexpectedEof => ENDS_TOO_EARLY.into(),
        Error::Unsupported(_) => not_supported(error),
        Error::Format(reason) if reason.contains("unset") => format!(
            "it lacks tables that its pixels need, as single frames of a motion JPEG do ({reason}); \
             save it as PNG with another program"
        ),
        error => refused(error),
    }
}
