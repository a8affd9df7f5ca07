//! A picture of six pixels, whose file is known byte by byte.

use common::{Color, Image, Size};
use measure::extremes::Bound;
use testing::exercise::Check;

pub fn check(check: &mut Check, ppm: impl Fn(&Image) -> Vec<u8>) {
    let colors = [
        (Color::RED, [255, 0, 0]),
        (Color::GREEN, [0, 255, 0]),
        (Color::BLUE, [0, 0, 255]),
        // No byte is to be taken for a line.
        (Color::from_bytes([10, 13, 32]), [10, 13, 32]),
        (Color::new(2.0, 0.5, -1.0), [255, 128, 0]),
        (Color::WHITE, [255, 255, 255]),
    ];
    for (width, height) in [(3, 2), (2, 3), (6, 1)] {
        let Ok(size) = Size::new(width, height) else {
            continue;
        };
        let color = |x, y| colors[(y * width + x) as usize].0;
        let Ok(image) = Image::from_fn(size, color) else {
            continue;
        };
        let mut exact = format!("P6\n{width} {height}\n255\n").into_bytes();
        exact.extend(colors.iter().flat_map(|(_, bytes)| bytes));

        let got = ppm(&image);
        let length = format!("bytes of the file of {size}");
        check.expect(length, exact.len(), Bound::Equal, got.len());
        let differs = (0..exact.len()).find(|&i| got.get(i) != exact.get(i));
        let first = format!("the first wrong byte of the file of {size}, counted from 0");
        check.expect(first, None::<usize>, Bound::Equal, differs);
    }
}
