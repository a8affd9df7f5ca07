//! The difference of a picture from the expected one, in words and in pictures.

use std::fs;
use std::path::{Path, PathBuf};

use crate::{Color, Image, Transfer, picture_file};

/// Describes the difference of a picture from the expected one, if there is one.
fn compare(expected: &Image, actual: &Image) -> Result<(), String> {
    let (size, other) = (expected.size(), actual.size());
    if size != other {
        return Err(format!("expected {size} pixels, got {other}"));
    }
    let apart = apart(expected, actual);
    let mut differing = (0..).zip(&apart).filter(|(_, pixel)| **pixel != [0; 3]);
    let Some((first, _)) = differing.next() else {
        return Ok(());
    };
    let (count, largest) = (1 + differing.count(), apart.as_flattened().iter().max());
    let (x, y) = (first % size.width(), first / size.width());
    let [wanted, got] = [expected, actual].map(|image| {
        let color = image.get(x, y).unwrap_or_default();
        Transfer::Linear.bytes(color)
    });
    Err(format!(
        "{count} of {} pixels differ, a channel by at most {} of 255; \
         the first is column {x}, row {y}: expected {wanted:?}, got {got:?}",
        size.pixels(),
        largest.unwrap_or(&0),
    ))
}

/// The differences of the light in the channels of a picture from those of another one of the same
/// size, three for each pixel; infinite where one of both is no number.
#[must_use]
pub fn of_channels(image: &Image, expected: &Image) -> Vec<f64> {
    let mut differences = Vec::new();
    for (pixel, expected) in image.pixels().iter().zip(expected.pixels()) {
        for (channel, expected) in pixel.channels().into_iter().zip(expected.channels()) {
            let difference = channel - expected;
            differences.push(match difference {
                _ if channel.to_bits() == expected.to_bits() => 0.0,
                nan if nan.is_nan() => f64::INFINITY,
                difference => difference,
            });
        }
    }
    differences
}

/// The differences of the channels of each pixel, in the bytes of two pictures.
fn apart(expected: &Image, actual: &Image) -> Vec<[u8; 3]> {
    let [expected, actual] = [expected, actual].map(|image| image.to_rgb8(Transfer::Linear));
    let channels = expected.iter().zip(&actual).map(|(e, a)| e.abs_diff(*a));
    channels.collect::<Vec<_>>().as_chunks().0.to_vec()
}

/// The pixel with the largest difference of a channel in pictures of the same size, and that
/// difference.
#[must_use]
pub fn largest(expected: &Image, actual: &Image) -> Option<([u32; 2], u8)> {
    let pixels = apart(expected, actual).into_iter();
    let most = pixels.map(|[r, g, b]| r.max(g).max(b));
    let (at, most) = (0..).zip(most).max_by_key(|(_, most)| *most)?;
    let width = actual.size().width();
    (expected.size() == actual.size()).then_some(([at % width, at / width], most))
}

/// The pixel in which a picture differs most from the expected one; the middle one if no channel
/// differs by more than 1 of 255.
#[must_use]
pub fn worst_pixel(expected: &Image, image: &Image) -> Option<[u32; 2]> {
    let (worst, most) = largest(expected, image)?;
    let size = image.size();
    let middle = [size.width() / 2, size.height() / 2];
    Some(if most > 1 { worst } else { middle })
}

/// Compares a picture with the one in a file.
///
/// # Errors
///
/// The error describes the difference, or why the file cannot be read.
pub fn compare_with_file(expected: &Path, image: &Image) -> Result<(), String> {
    picture_file::open(expected)
        .map_err(|error| error.to_string())
        .and_then(|stored| compare(&stored, image))
}

/// Writes the actual, the expected and the difference picture into a folder, and
/// returns a message with their paths.
#[must_use]
pub fn leave_pictures(scratch: &Path, expected: &Path, actual: &Image, difference: &str) -> String {
    let write = |kind: &str, image: &Image| {
        let path = left_picture(scratch, expected, kind);
        let written = picture_file::save_png(&path, image.size(), &image.to_rgb8(Transfer::Linear));
        written.map_or_else(|error| error.to_string(), |()| path.display().to_string())
    };
    let mut report = vec![
        difference.to_owned(),
        format!("  actual:     {}", write("actual", actual)),
    ];
    if let Ok(expected) = picture_file::open(expected) {
        report.push(format!("  expected:   {}", write("expected", &expected)));
        if let Some(([column, row], most)) = largest(&expected, actual) {
            // Small differences are seen, too.
            let (times, apart) = (255 / most.max(1), apart(&expected, actual));
            let scale = match times {
                1 => String::new(),
                _ => format!(", {times} times as large"),
            };
            let shown = Image::from_fn(actual.size(), |x, y| {
                let from_largest = x.abs_diff(column).max(y.abs_diff(row));
                if (5..7).contains(&from_largest) {
                    return Color::new(1.0, 1.0, 0.0);
                }
                let pixel = apart[(y * actual.size().width() + x) as usize];
                Color::from_bytes(pixel.map(|channel| channel * times))
            });
            let path = shown.map_or_else(
                |error| error.to_string(),
                |shown| write("difference", &shown),
            );
            report.push(format!(
                "  difference: {path}{scale}, the largest in a yellow frame"
            ));
        }
    }
    report.join("\n")
}

/// Removes the pictures that [`leave_pictures`] has written: the picture is right.
pub fn remove_pictures(scratch: &Path, expected: &Path) {
    for kind in ["actual", "expected", "difference"] {
        // Mostly there is none.
        let _ = fs::remove_file(left_picture(scratch, expected, kind));
    }
}

/// The file of a picture of this kind.
fn left_picture(scratch: &Path, expected: &Path, kind: &str) -> PathBuf {
    let name = Path::new(expected.file_name().unwrap_or_default());
    scratch.join(name.with_extension(format!("{kind}.png")))
}

#[cfg(test)]
mod tests {
    use crate::Size;

    use super::*;

    #[test]
    fn nan_differs_from_all_but_itself() {
        let dot = |gray| {
            let size = Size::new(1, 1).unwrap();
            Image::from_fn(size, |_, _| Color::gray(gray)).unwrap()
        };
        let apart = |a, b| of_channels(&dot(a), &dot(b));
        assert_eq!(apart(f64::NAN, f64::NAN), [0.0; 3]);
        assert_eq!(apart(f64::INFINITY, f64::INFINITY), [0.0; 3]);
        assert_eq!(apart(f64::NAN, 1.0), [f64::INFINITY; 3]);
        assert_eq!(apart(0.25, 1.0), [-0.75; 3]);
    }

    #[test]
    fn a_difference_is_described_in_full() {
        let black = |width| Image::black(Size::new(width, 64).unwrap()).unwrap();
        let mut other = black(96);
        assert_eq!(compare(&black(96), &other), Ok(()));
        other.set(5, 2, Color::from_bytes([0, 7, 0]));
        other.set(9, 60, Color::from_bytes([3, 0, 0]));
        let text = "2 of 6144 pixels differ, a channel by at most 7 of 255; \
                    the first is column 5, row 2: expected [0, 0, 0], got [0, 7, 0]";
        assert_eq!(compare(&black(96), &other).unwrap_err(), text);
        let text = "expected 96x64 pixels, got 97x64";
        assert_eq!(compare(&black(96), &black(97)).unwrap_err(), text);
    }
}
