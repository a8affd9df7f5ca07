//! `ShowImage`: a picture from a file.

use std::path::Path;

use common::{Error, Image, picture_file};

/// The card makes errors of a screen visible: bars of colour, a ramp of grey, a
/// circle and a grid that must not be distorted, stripes beside flat greys (the
/// grey that looks as bright as the stripes determines the screen's gamma), and
/// a border one pixel wide that is missing if edges are cut.
const TEST_CARD: &[u8] = include_bytes!("../assets/test-card.png");

/// A picture that was opened, not computed.
#[derive(Clone, Debug, PartialEq)]
pub struct ShowImage {
    image: Image,
}

impl ShowImage {
    /// Opens a PNG, JPEG or BMP file; the format is read from its content.
    pub fn open(path: &Path) -> Result<Self, Error> {
        let image = picture_file::open(path)?;
        Ok(Self { image })
    }

    /// The bundled test card, 640x480 pixels.
    pub fn test_card() -> Result<Self, Error> {
        let image = picture_file::open_bytes(Path::new("test-card.png"), TEST_CARD)?;
        Ok(Self { image })
    }

    /// The picture.
    #[must_use]
    pub fn into_image(self) -> Image {
        self.image
    }
}
