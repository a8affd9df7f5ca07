//! Decodes JPEG files.

use std::io;

use image::metadata::Orientation;
use image::{DynamicImage, GrayImage, RgbImage};
use jpeg_decoder::{ColorTransform, Decoder, Error, PixelFormat};

use super::{ENDS_TOO_EARLY, not_supported, refused};
use crate::Size;

/// The marker of the end of a picture.
const END: u8 = 0xD9;

/// The picture of a file, and how it is to be rotated and mirrored. The error is a clause.
pub fn decode(bytes: &[u8]) -> Result<(DynamicImage, Orientation), String> {
    let markers = Markers::read(bytes);
    if markers.is_lossless {
        return Err(not_supported("lossless JPEG"));
    }
    // The decoder would take missing data for zeros. So bits that are all 1 stand before the end: no code consists
    // of such bits alone, and of a whole picture none of them is read. Behind 0xFF, 0 says that it is no marker.
    let guarded = match markers.end {
        Some(end) => [&bytes[..end], &[0xFF, 0].repeat(16), &[0xFF, END]].concat(),
        None => bytes.to_vec(),
    };
    let mut decoder = Decoder::new(guarded.as_slice());
    decoder.read_info().map_err(explain)?;
    let info = decoder.info().ok_or("it has no picture")?;
    let (width, height) = (u32::from(info.width), u32::from(info.height));
    Size::new(width, height).map_err(|error| error.to_string())?;
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

/// What the markers of a picture say.
#[derive(Default)]
struct Markers {
    /// JFIF pictures are gray, or YCbCr.
    is_jfif: bool,
    /// The transform of Adobe's marker: 0 for none, 1 for YCbCr, 2 for YCCK.
    adobe: Option<u8>,
    /// Whether the frame is lossless, by ITU-T T.81 or by T.87 (JPEG-LS). The decoder knows only a part of the first:
    /// where samples are shifted or intervals are restarted, it draws noise without an error.
    is_lossless: bool,
    /// Where the marker of the end stands. Behind it may be a second picture, or bytes of no meaning.
    end: Option<usize>,
}

impl Markers {
    /// The markers up to the end of the first picture.
    fn read(bytes: &[u8]) -> Self {
        // In the data of a scan, 0xFF stands only before 0 and before the numbers of restarts. Fill bytes may stand
        // before a marker.
        let is_marker = |pair: &[u8]| pair[0] == 0xFF && !matches!(pair[1], 0 | 0xD0..=0xD7 | 0xFF);
        let mut markers = Self::default();
        // Behind the marker of the beginning.
        let mut place = 2;
        while let Some(rest) = bytes.get(place..)
            && let Some(before) = rest.windows(2).position(is_marker)
            && let [_, marker, segment @ ..] = &rest[before..]
        {
            place += before;
            if *marker == END {
                markers.end = Some(place);
                break;
            }
            let [high, low, ..] = *segment else {
                break;
            };
            // The length of a segment includes its own two bytes.
            let length = usize::from(u16::from_be_bytes([high, low]));
            let content = segment.get(2..length).unwrap_or_default();
            match marker {
                0xC3 | 0xC7 | 0xCB | 0xCF | 0xF7 => markers.is_lossless = true,
                0xE0 if content.starts_with(b"JFIF\0") => markers.is_jfif = true,
                0xEE if content.starts_with(b"Adobe") => markers.adobe = content.get(11).copied(),
                _ => {}
            }
            place += 2 + length;
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
