//! `diagonal`: the lesson's own.

use crate::prelude::*;

pub fn diagonal(size: Size) -> Result<Image, Error> {
    PaintDiagonal::new(size).image()
}
