//! `Size`: width and height of a picture, checked before memory is allocated.

use std::fmt;
use std::str::FromStr;

use crate::ArgumentError;

const MAX_SIDE: u32 = 32_768;

/// Pixels of the largest picture, which take 1.5 GiB in linear colours.
const MAX_PIXELS: u32 = 8192 * 8192;

/// Width and height of a picture in pixels, each from 1 to 32768, and at most as many
/// pixels as 8192x8192 has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

impl Size {
    /// The size of the course's pictures.
    pub const COURSE: Self = Self {
        width: 640,
        height: 480,
    };

    /// The size of the second course's pictures.
    pub const SECOND_COURSE: Self = Self {
        width: 480,
        height: 270,
    };

    /// A size, if it is within the limits.
    pub fn new(width: u32, height: u32) -> Result<Self, ArgumentError> {
        let sides = 1..=MAX_SIDE;
        let is_valid = sides.contains(&width) && sides.contains(&height);
        if is_valid && width * height <= MAX_PIXELS {
            Ok(Self { width, height })
        } else {
            Err(ArgumentError::new(
                "size",
                format!("{width}x{height}"),
                "from 1 to 32768 pixels a side and at most 8192x8192 in all",
            ))
        }
    }

    /// Pixels in a row.
    #[must_use]
    pub const fn width(self) -> u32 {
        self.width
    }

    /// Number of rows.
    #[must_use]
    pub const fn height(self) -> u32 {
        self.height
    }

    /// Number of pixels.
    #[must_use]
    pub const fn pixels(self) -> usize {
        self.width as usize * self.height as usize
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl FromStr for Size {
    type Err = ArgumentError;

    /// Reads `640x480`.
    fn from_str(text: &str) -> Result<Self, ArgumentError> {
        let sides = text.split_once(['x', 'X']).and_then(|(width, height)| {
            let [width, height] = [width, height].map(|side| side.parse().ok());
            Some((width?, height?))
        });
        let (width, height) = sides.ok_or_else(|| {
            ArgumentError::new(
                "size",
                format!("\"{}\"", crate::text::name(text)),
                "WIDTHxHEIGHT, such as 640x480",
            )
        })?;
        Self::new(width, height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_as_they_are_printed() {
        for text in ["640x480", "1x1", "32768x2048", "8192x8192"] {
            assert_eq!(text.parse::<Size>().unwrap().to_string(), text);
        }
    }

    #[test]
    fn wrong_sizes_are_refused_with_the_reason() {
        for text in "640 x 640x 640x-1 axb 640x480x3 99999999999x1".split(' ') {
            let error = text.parse::<Size>().unwrap_err().to_string();
            assert!(error.contains("WIDTHxHEIGHT"), "{error}");
        }
        for text in "0x0 0x480 640x0 32769x1 1x32769 8192x8193 65536x65536".split(' ') {
            let error = text.parse::<Size>().unwrap_err().to_string();
            assert!(error.contains("from 1 to 32768"), "{error}");
        }
    }
}
