//! Pictures of random bytes, whose files are known byte by byte.

use common::{Color, Image, Size};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, ppm: impl Fn(&Image) -> Vec<u8>) {
    let mut random = Random::new(1);
    for (width, height) in [(3, 2), (2, 3), (6, 1), (1, 1), (1, 12), (300, 2), (9, 101)] {
        let Ok(size) = Size::new(width, height) else {
            continue;
        };
        // 10, 13 and 32 end lines and words of a text.
        let mut pixels: Vec<u8> = (0..3 * size.pixels())
            .map(|_| random.below(256) as u8)
            .collect();
        pixels[..3].copy_from_slice(&[10, 13, 32]);
        let color = |x: u32, y: u32| {
            let i = 3 * (y * width + x) as usize;
            Color::from_bytes([pixels[i], pixels[i + 1], pixels[i + 2]])
        };
        let Ok(image) = Image::from_fn(size, color) else {
            continue;
        };
        let file = ppm(&image);
        expect_file(check, size, &pixels, &file);
    }

    // Brighter than white is white, darker than black is black.
    let Ok(size) = Size::new(1, 1) else { return };
    if let Ok(image) = Image::from_fn(size, |_, _| Color::new(2.0, 0.5, -1.0)) {
        expect_file(check, size, &[255, 128, 0], &ppm(&image));
    }
}

fn expect_file(check: &mut Check, size: Size, pixels: &[u8], file: &[u8]) {
    let (width, height) = (size.width(), size.height());
    let header = format!("P6\n{width} {height}\n255\n");
    // As many bytes as the right header has.
    let got = &file[..file.len().min(header.len())];
    let what = format!(
        "a picture of {size} begins with {header:?}, not {:?}",
        String::from_utf8_lossy(got)
    );
    check.expect(what, true, Bound::Equal, got == header.as_bytes());

    let got = file.get(header.len()..).unwrap_or_default();
    if let Some(i) = (0..pixels.len()).find(|&i| got.get(i) != pixels.get(i)) {
        let (channel, pixel) = (["red", "green", "blue"][i % 3], i / 3);
        let (x, y) = (pixel % width as usize, pixel / width as usize);
        let byte = |bytes: &[u8]| bytes.get(i).map(|&byte| usize::from(byte));
        let what = format!("{channel} in column {x} and row {y} of a picture of {size}");
        check.expect(what, byte(pixels), Bound::Equal, byte(got));
    }
    let exact = header.len() + pixels.len();
    let what = format!("bytes of the file of a picture of {size}");
    check.expect(what, exact, Bound::Equal, file.len());
}
