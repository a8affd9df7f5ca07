//! Picture files: PNG, JPEG and BMP, whole and broken.

use std::io::Cursor;
use std::path::Path;

use common::{Size, picture_file};
use image::ImageReader;

/// Larger pictures that the limits allow are not opened: they would take all the time.
const MOST_PIXELS: usize = 1 << 12;

/// Opens the bytes as a picture: the channels are from 0 to 1, or there is a reason.
pub fn check(bytes: &[u8]) {
    let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format();
    let size = reader.ok().and_then(|reader| reader.into_dimensions().ok());
    let size = size.and_then(|(width, height)| Size::new(width, height).ok());
    if size.is_some_and(|size| size.pixels() > MOST_PIXELS) {
        return;
    }
    match picture_file::open_bytes(Path::new("picture"), bytes) {
        Ok(picture) => {
            let is_shown = |channel| (0.0..=1.0).contains(&channel);
            let mut channels = picture.pixels().iter().flat_map(|pixel| pixel.channels());
            assert!(channels.all(is_shown));
        }
        Err(error) => {
            let error = error.to_string();
            let reason = error.strip_prefix("cannot open picture: ");
            assert!(reason.is_some_and(|reason| !reason.is_empty()), "{error}");
        }
    }
}
