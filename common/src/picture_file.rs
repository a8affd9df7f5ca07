//! Opens picture files, and writes PNG files so that each is complete or absent.

mod jpeg;
mod png_faults;

use std::fmt::Display;
use std::io::{self, Cursor};
use std::path::Path;

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::metadata::Orientation;
use image::{
    DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder, ImageError, ImageFormat,
    ImageReader, Limits,
};

use crate::{Color, Error, Image, Size, atomic_file, file};

/// Longer files are not opened, because a file is read as a whole. The largest picture that
/// opens, with 16 bits per channel, has half as many bytes.
const MAX_FILE_BYTES: u64 = 1 << 30;

/// Most memory for metadata. The largest are colour profiles, which are compressed in
/// the file and have a few megabytes at most.
const MAX_BYTES_BESIDE_PIXELS: u64 = 1 << 24;

const ENDS_TOO_EARLY: &str = "the file ends too early; it may be only half copied";

/// Opens a PNG, JPEG or BMP file with any suffix. Colours are taken as they are
/// stored, with 8 bits per channel; transparent pixels are blended with black.
///
/// The size is checked before memory is allocated for the pixels.
pub fn open(path: &Path) -> Result<Image, Error> {
    let bytes = file::read(Path::new(""), path, MAX_FILE_BYTES);
    open_bytes(path, &bytes.map_err(|reason| cannot_open(path, reason))?)
}

/// Like [`open`], for a picture file in memory, such as one that is part of the
/// program. Errors call it `name`.
pub fn open_bytes(name: &Path, bytes: &[u8]) -> Result<Image, Error> {
    let decoded = decode(bytes).map_err(|reason| cannot_open(name, reason))?;
    let size = Size::new(decoded.width(), decoded.height())?;
    let mut image = Image::black(size)?;
    let rgba = decoded.into_rgba8();
    for (pixel, rgba) in image.pixels_mut().iter_mut().zip(rgba.pixels()) {
        let [red, green, blue, opacity] = rgba.0;
        *pixel = Color::from_bytes([red, green, blue]) * (f64::from(opacity) / 255.0);
    }
    Ok(image)
}

fn cannot_open(path: &Path, reason: String) -> Error {
    Error::Open {
        path: path.to_owned(),
        reason,
    }
}

/// The picture, rotated and mirrored as the file says. The error is a clause.
fn decode(bytes: &[u8]) -> Result<DynamicImage, String> {
    let format = image::guess_format(bytes).map_err(|_| "it is no PNG, JPEG or BMP picture")?;
    let (mut picture, orientation) = match format {
        ImageFormat::Jpeg => jpeg::decode(bytes)?,
        ImageFormat::Png | ImageFormat::Bmp => decode_lossless(bytes, format)?,
        other => {
            let kind = other.to_mime_type();
            return Err(format!(
                "it is {kind}, and only PNG, JPEG and BMP pictures open"
            ));
        }
    };
    picture.apply_orientation(orientation);
    Ok(picture)
}

fn decode_lossless(
    bytes: &[u8],
    format: ImageFormat,
) -> Result<(DynamicImage, Orientation), String> {
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::default();
    // The pixels have their own limit, the size of the picture.
    limits.max_alloc = Some(MAX_BYTES_BESIDE_PIXELS);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(explain)?;
    let (width, height) = decoder.dimensions();
    Size::new(width, height).map_err(|error| error.to_string())?;
    let orientation = decoder.orientation().map_err(explain)?;
    let pixels = DynamicImage::from_decoder(decoder).map_err(explain)?;
    if format == ImageFormat::Png
        && let Some(fault) = png_faults::fault(bytes)
    {
        return Err(format!("{fault}; save it anew with another program"));
    }
    Ok((pixels, orientation))
}

fn explain(error: ImageError) -> String {
    match error {
        ImageError::Unsupported(error) => not_supported(error),
        ImageError::IoError(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
            ENDS_TOO_EARLY.to_owned()
        }
        ImageError::Limits(_) => "it asks for more memory than the largest pictures take".into(),
        error => refused(error),
    }
}

/// The clause about a picture of a kind that its decoder does not know.
fn not_supported(kind: impl Display) -> String {
    format!("it is of a kind that is not supported ({kind}); save it as PNG with another program")
}

/// The clause about a picture that its decoder refuses: it may be damaged, or right in a way that the decoder does
/// not know.
fn refused(error: impl Display) -> String {
    format!("its decoder refuses it ({error}); if another program opens it, save it as PNG there")
}

/// Writes a PNG file of red, green and blue bytes, row after row from the top. Other
/// programs always find the old file or the complete new one.
///
/// # Panics
///
/// If `rgb` does not hold three bytes for every pixel of `size`.
pub fn save_png(path: &Path, size: Size, rgb: &[u8]) -> Result<(), Error> {
    let mut png = Vec::new();
    let (fast, adaptive) = (CompressionType::Fast, FilterType::Adaptive);
    PngEncoder::new_with_quality(&mut png, fast, adaptive)
        .write_image(rgb, size.width(), size.height(), ExtendedColorType::Rgb8)
        .map_err(|error| atomic_file::cannot_write(path, &io::Error::other(error)))?;
    atomic_file::write(path, &png)
}

#[cfg(test)]
mod tests;
