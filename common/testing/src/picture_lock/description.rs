//! `describe`: a picture as text, so that a person sees changes in a diff.

use common::{Size, fnv1a};

/// Width of the thumbnail in characters.
const COLUMNS: usize = 48;

/// The text half of a lock.
pub fn describe(size: Size, rgb: &[u8]) -> String {
    let mut lines = vec![
        format!("size {size}"),
        format!("hash {:016x}", fnv1a(rgb)),
        "brightness and hue (capital: bright)".to_owned(),
    ];
    let (width, height) = (size.width() as usize, size.height() as usize);
    // A character is about twice as high as it is wide.
    let rows = (COLUMNS * height / width / 2).max(1);
    for row in 0..rows {
        let y = row * height / rows..((row + 1) * height).div_ceil(rows);
        let cell = |column: usize| {
            let x = column * width / COLUMNS..((column + 1) * width).div_ceil(COLUMNS);
            mean(rgb, width, x, y.clone())
        };
        let cells: Vec<_> = (0..COLUMNS).map(cell).collect();
        let characters = |f: fn(&[f64; 3]) -> char| cells.iter().map(f).collect::<String>();
        lines.push(format!(
            "|{}|  |{}|",
            characters(brightness),
            characters(hue)
        ));
    }
    lines.join("\n")
}

/// The mean of each channel over columns `x` and rows `y`, from 0 to 255.
fn mean(
    rgb: &[u8],
    width: usize,
    x: std::ops::Range<usize>,
    y: std::ops::Range<usize>,
) -> [f64; 3] {
    let count = (x.len() * y.len()) as f64;
    let cells = y.flat_map(|y| x.clone().map(move |x| 3 * (y * width + x)));
    let sums = cells.fold([0_u64; 3], |sums, at| {
        [0, 1, 2].map(|channel| sums[channel] + u64::from(rgb[at + channel]))
    });
    sums.map(|sum| sum as f64 / count)
}

fn brightness(&[r, g, b]: &[f64; 3]) -> char {
    const RAMP: &[u8; 10] = b" .:-=+*#%@";
    // Weights of ITU-R BT.709.
    let luminance = (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255.0;
    char::from(RAMP[(luminance * 9.0 + 0.5) as usize])
}

fn hue(channels: &[f64; 3]) -> char {
    // The letters of red, green, blue and their sums, by which channels are on.
    const NAMES: &[u8; 8] = b" rgybmcw";
    let strongest = channels.iter().copied().fold(0.0, f64::max);
    let on = |channel: usize| usize::from(channels[channel] > strongest / 2.0) << channel;
    let name = char::from(NAMES[on(0) | on(1) | on(2)]);
    match strongest {
        ..8.0 => '.',
        ..128.0 => name,
        _ => name.to_ascii_uppercase(),
    }
}

#[cfg(test)]
mod tests {
    use common::{Color, Image, Transfer};

    use super::*;

    #[test]
    fn the_thumbnail_shows_brightness_and_hue() {
        let half = |x, _| {
            if x < 48 {
                Color::WHITE
            } else {
                Color::RED * 0.4
            }
        };
        let halves = Image::from_fn(Size::new(96, 64).unwrap(), half).unwrap();
        let text = describe(halves.size(), &halves.to_rgb8(Transfer::Linear));
        let line = text.lines().nth(3).unwrap();
        let expected = format!(
            "|{}{}|  |{}{}|",
            "@".repeat(24),
            ".".repeat(24),
            "W".repeat(24),
            "r".repeat(24)
        );
        assert_eq!(line, expected);
        assert_eq!(text.lines().count(), 3 + 16);
    }
}
