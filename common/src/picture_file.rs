//! Opens picture files, and writes PNG files so that each is complete or absent.

mod catch_quietly;
mod jpeg;
mod kind;

use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::Path;

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::metadata::Orientation;
use image::{
    DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder, ImageError, ImageReader, Limits,
};

use crate::{Color, Error, Image, Size, atomic_file};
use catch_quietly::catch_quietly;
use jpeg::Jpeg;

/// Longer files are not opened, because a file is read as a whole. The largest picture that
/// opens, with 16 bits per channel, has half as many bytes.
const LONGEST_FILE: u64 = 1 << 30;

/// Most memory for metadata. The largest are colour profiles, which are compressed in
/// the file and have a few megabytes at most.
const MOST_BYTES_BESIDE_PIXELS: u64 = 1 << 24;

/// Opens a PNG, JPEG or BMP file with any suffix. Colours are taken as they are
/// stored, with 8 bits per channel; transparent pixels are blended with black.
///
/// The size is checked before memory is allocated for the pixels.
pub fn open(path: &Path) -> Result<Image, Error> {
    if path.is_dir() {
        return Err(cannot_open(path, "it is a folder, not a picture"));
    }
    let unread = |error: io::Error| match error.kind() {
        io::ErrorKind::NotFound => cannot_open(path, "there is no such file"),
        _ => cannot_open(path, error.to_string()),
    };
    let file = File::open(path).map_err(unread)?;
    if file.metadata().is_ok_and(|data| data.len() > LONGEST_FILE) {
        return Err(cannot_open(path, "it is longer than 1 GiB"));
    }
    let mut bytes = Vec::new();
    let read = file.take(LONGEST_FILE).read_to_end(&mut bytes);
    read.map_err(unread)?;
    open_bytes(path, &bytes)
}

/// Like [`open`], for a picture file in memory, such as one that is part of the
/// program. Errors call it `name`.
pub fn open_bytes(name: &Path, bytes: &[u8]) -> Result<Image, Error> {
    // The JPEG decoder panics on some damaged files.
    let decoded = catch_quietly(|| decode(bytes));
    let decoded = decoded.unwrap_or_else(|| Err("the file is damaged".to_owned()));
    let (size, rgba) = decoded.map_err(|reason| cannot_open(name, reason))?;
    let mut image = Image::black(size)?;
    for (pixel, rgba) in image.pixels_mut().iter_mut().zip(rgba.chunks_exact(4)) {
        let opacity = f64::from(rgba[3]) / 255.0;
        *pixel = Color::from_bytes([rgba[0], rgba[1], rgba[2]]) * opacity;
    }
    Ok(image)
}

fn cannot_open(path: &Path, reason: impl Into<String>) -> Error {
    Error::Open {
        path: path.to_owned(),
        reason: reason.into(),
    }
}

const ENDS_TOO_EARLY: &str = "the file ends too early; it may be only half copied";

/// The size and the bytes of red, green, blue and opacity of a picture. The error is a sentence.
fn decode(bytes: &[u8]) -> Result<(Size, Vec<u8>), String> {
    if bytes.starts_with(&[0xFF, 0xD8, 0xFF]) {
        return decode_jpeg(bytes);
    }
    if bytes.starts_with(b"BM")
        && let Some(kind) = kind::unsupported_bmp(bytes)
    {
        return Err(kind::not_supported(&kind));
    }
    decode_known(bytes)
}

/// Like [`decode`]. A file that ends too early is an error, unless only its end mark is missing.
fn decode_jpeg(bytes: &[u8]) -> Result<(Size, Vec<u8>), String> {
    let jpeg = Jpeg::read(bytes)?;
    let decoded = match decode_stored(&jpeg.with_end(bytes)) {
        Err(_) if !jpeg.has_end => return Err(ENDS_TOO_EARLY.to_owned()),
        decoded => decoded?,
    };
    let continued = decode_stored(&jpeg.continued());
    let is_same = continued.is_ok_and(|other| other.pixels == decoded.pixels);
    if is_same && jpeg.has_all_scans() {
        decoded.into_rgba()
    } else {
        Err(ENDS_TOO_EARLY.to_owned())
    }
}

/// The picture of a file of a supported kind, as its decoder sees it.
fn decode_known(bytes: &[u8]) -> Result<(Size, Vec<u8>), String> {
    decode_stored(bytes)?.into_rgba()
}

/// A picture with the channels of its file.
struct Stored {
    pixels: DynamicImage,
    /// How the pixels are to be rotated and mirrored.
    orientation: Orientation,
}

impl Stored {
    fn into_rgba(mut self) -> Result<(Size, Vec<u8>), String> {
        self.pixels.apply_orientation(self.orientation);
        let size = Size::new(self.pixels.width(), self.pixels.height());
        let size = size.map_err(|error| error.to_string())?;
        Ok((size, self.pixels.into_rgba8().into_raw()))
    }
}

fn decode_stored(bytes: &[u8]) -> Result<Stored, String> {
    let explain = |error: ImageError| explain(&error, bytes);
    let mut reader = ImageReader::new(Cursor::new(bytes))
        .with_guessed_format()
        .map_err(|error| error.to_string())?;
    let mut limits = Limits::default();
    // The pixels have their own limit, the size of the picture.
    limits.max_alloc = Some(MOST_BYTES_BESIDE_PIXELS);
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(explain)?;
    let (width, height) = decoder.dimensions();
    Size::new(width, height).map_err(|error| error.to_string())?;
    let orientation = decoder.orientation().map_err(explain)?;
    let pixels = DynamicImage::from_decoder(decoder).map_err(explain)?;
    Ok(Stored {
        pixels,
        orientation,
    })
}

fn explain(error: &ImageError, bytes: &[u8]) -> String {
    match error {
        ImageError::Unsupported(_) => kind::no_picture(bytes),
        ImageError::IoError(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
            ENDS_TOO_EARLY.to_owned()
        }
        ImageError::IoError(error) => error.to_string(),
        ImageError::Limits(_) => "it asks for more memory than the largest pictures take".into(),
        error => format!("the file is damaged ({error})"),
    }
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
