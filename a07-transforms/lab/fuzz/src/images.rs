//! Picture files: PNG, JPEG and BMP, whole and broken.

use std::io::Cursor;
use std::path::Path;

use common::{Size, picture_file};
use image::ImageReader;

/// Larger pictures that the limits allow are not opened: they would take all the time.
const MAX_PIXELS: usize = 1 << 12;

/// Opens the bytes as a picture: the channels are from 0 to 1, or there is a reason.
pub fn check(bytes: &[u8]) {
    if size(bytes).is_some_and(|size| size.pixels() > MAX_PIXELS) {
        return;
    }
    match picture_file::open_bytes(Path::new("picture"), bytes) {
        Ok(picture) => {
            for pixel in picture.pixels() {
                for channel in pixel.channels() {
                    assert!((0.0..=1.0).contains(&channel), "{pixel:?}");
                }
            }
        }
        Err(error) => {
            let error = error.to_string();
            let reason = error.strip_prefix("cannot open picture: ");
            assert!(reason.is_some_and(|reason| !reason.is_empty()), "{error}");
        }
    }
}

/// The size that the head of a picture file names.
fn size(bytes: &[u8]) -> Option<Size> {
    let reader = ImageReader::new(Cursor::new(bytes));
    let reader = reader.with_guessed_format().ok()?;
    let (width, height) = reader.into_dimensions().ok()?;
    Size::new(width, height).ok()
}
