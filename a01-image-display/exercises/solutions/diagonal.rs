//! `diagonal`: the lesson's own.

use a01_image_display::PaintDiagonal;
use common::{Error, Image, Size};

pub fn diagonal(size: Size) -> Result<Image, Error> {
    PaintDiagonal::new(size).image()
}
