//! Picture files: PNG, JPEG and BMP, whole and broken.

use std::io::Cursor;
use std::path::Path;

use common::picture_file;
use image::ImageReader;

/// Larger pictures that the limits allow are not opened: they would take all the time.
const MOST_PIXELS: u64 = 1 << 12;

/// Opens the bytes as a picture: the channels are from 0 to 1, or there is a reason.
pub fn check(bytes: &[u8]) {
    let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format();
    let size = reader.ok().and_then(|reader| reader.into_dimensions().ok());
    let is_large = |(width, height)| u64::from(width) * u64::from(height) > MOST_PIXELS;
    let opens_if_whole = |(width, height)| common::Size::new(width, height).is_ok();
    if size.is_some_and(|size| is_large(size) && opens_if_whole(size)) {
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
