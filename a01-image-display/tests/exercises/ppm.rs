//! Files of pictures of random bytes, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: &dyn Fn(&Image) -> Vec<u8>) {
    check.compare(
        "a picture of {}x{} with the bytes {}",
        [(1, 1, b"RGB".to_vec()), (2, 1, b"red\n\r ".to_vec())],
        random(|r| {
            let (w, h) = (1 + r.below(4), 1 + r.below(4));
            (w, h, (0..3 * w * h).map(|_| r.below(256) as u8).collect())
        }),
        [&ppm as _, yours],
        |ppm, (w, h, bytes): (_, _, Vec<u8>)| {
            let rgb = |x, y| [0, 1, 2].map(|i| bytes[(3 * (y * w + x) + i) as usize]);
            let image = Image::from_fn(Size::new(w, h).ok()?, |x, y| Color::from_bytes(rgb(x, y)));
            Some(Answer::words(ppm(&image.ok()?).escape_ascii().to_string()))
        },
    );
}

variants! { lines:
    yours => &ppm;
    wrong "the width comes before the height" => |w, h| format!("P6\n{h} {w}\n255\n");
    wrong "a line feed ends 255, and no line is empty" => |w, h| format!("P6\n{w} {h}\n255\n\n");
    wrong "P6 has bytes, P3 numbers in words" => |w, h| format!("P3\n{w} {h}\n255\n");
}

/// A file whose first lines follow from width and height.
fn lines(c: &mut Check, lines: fn(u32, u32) -> String) {
    check(c, &|image| {
        let lines = lines(image.size().width(), image.size().height());
        [lines.into_bytes(), image.to_rgb8(Transfer::Linear)].concat()
    });
}
