//! The pictures of this stage, under the names of the course.

use std::path::Path;

use common::{Error, Image, Size};

use crate::{PaintDiagonal, Painter, ShowImage};

/// A red diagonal on black.
pub fn diagonal(size: Size) -> Result<Image, Error> {
    PaintDiagonal::new(size).image()
}

/// A red disc before a gradient, from an array of packed pixels.
pub fn painter(size: Size) -> Result<Image, Error> {
    Painter::new(size, disc_on_gradient(size))?.image()
}

/// A picture file, or the bundled test card if there is none.
pub fn show_image(file: Option<&Path>) -> Result<Image, Error> {
    let shown = match file {
        Some(path) => ShowImage::open(path),
        None => ShowImage::test_card(),
    };
    shown.map(ShowImage::into_image)
}

/// Packed pixels: green grows to the right and blue to the top, and in the
/// middle lies a red disc whose radius is a quarter of the smaller side.
fn disc_on_gradient(size: Size) -> Vec<u32> {
    let (width, height) = (size.width(), size.height());
    // Linear from 0 at the first pixel to 255 at the last, rounded to nearest.
    let ramp = |at: u32, last: u32| (255 * at + last / 2) / last.max(1);
    let pixel = |x, y| {
        if in_disc(size, x, y) {
            0xFF_0000
        } else {
            ramp(x, width - 1) << 8 | ramp(height - 1 - y, height - 1)
        }
    };
    (0..height)
        .flat_map(|y| (0..width).map(move |x| pixel(x, y)))
        .collect()
}

/// Whether the middle of the pixel lies in the disc. All lengths are doubled,
/// so that they are whole numbers: dx and dy are twice the distances from
/// the picture's middle, and dx^2 + dy^2 <= (2r)^2 with 2r half the side.
fn in_disc(size: Size, x: u32, y: u32) -> bool {
    let twice = |at: u32, side: u32| i64::from(2 * at + 1) - i64::from(side);
    let (dx, dy) = (twice(x, size.width()), twice(y, size.height()));
    let side = i64::from(size.width().min(size.height()));
    4 * (dx * dx + dy * dy) <= side * side
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size(width: u32, height: u32) -> Size {
        Size::new(width, height).unwrap()
    }

    #[test]
    fn the_disc_has_the_area_of_a_circle() {
        for (width, height) in [(640, 480), (480, 270), (96, 72), (33, 100), (9, 9)] {
            let radius = f64::from(width.min(height)) / 4.0;
            let size = size(width, height);
            let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
            let area = places.filter(|(x, y)| in_disc(size, *x, *y)).count() as f64;
            // No point of a pixel is farther than sqrt(1/2) from its middle, so
            // the pixels cover a circle smaller by that much, and lie within
            // one larger by that much: the areas differ by pi (sqrt(2) r + 1/2)
            // at most.
            let exact = std::f64::consts::PI * radius * radius;
            let bound = std::f64::consts::PI * (std::f64::consts::SQRT_2 * radius + 0.5);
            assert!((area - exact).abs() <= bound, "{area} for {exact}");
        }
    }

    #[test]
    fn the_disc_ends_where_its_radius_does() {
        // Radius 120 around (320, 240): the pixel 120 to the right begins there.
        let course = size(640, 480);
        assert!(in_disc(course, 320 + 119, 240));
        assert!(!in_disc(course, 320 + 120, 240));
        assert!(in_disc(course, 320, 240 - 120));
        assert!(!in_disc(course, 320, 240 - 121));
    }

    #[test]
    fn the_corners_hold_the_ends_of_the_gradient() {
        let pixels = disc_on_gradient(Size::COURSE);
        let at = |x: usize, y: usize| pixels[y * 640 + x];
        assert_eq!(at(0, 0), 0x00_00FF);
        assert_eq!(at(639, 0), 0x00_FFFF);
        assert_eq!(at(0, 479), 0x00_0000);
        assert_eq!(at(639, 479), 0x00_FF00);
        assert_eq!(at(320, 240), 0xFF_0000);
    }
}
