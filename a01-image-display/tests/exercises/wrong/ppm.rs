//! Headers that no program reads, and pixels in a wrong order.

use common::{Image, Transfer};
use testing::exercise::Wrong;

use crate::ppm::check;

/// The file of this header, made of width and height, and of these pixels.
fn file(image: &Image, header: impl Fn(u32, u32) -> String, pixels: Vec<u8>) -> Vec<u8> {
    let mut file = header(image.size().width(), image.size().height()).into_bytes();
    file.extend(pixels);
    file
}

fn right_header(width: u32, height: u32) -> String {
    format!("P6\n{width} {height}\n255\n")
}

fn bytes(image: &Image) -> Vec<u8> {
    image.to_rgb8(Transfer::Linear)
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "height before width",
        says: r#"3x2 begins with "P6\n3 2\n255\n", not "P6\n2 3\n255\n""#,
        check: |c| {
            check(c, |i| {
                file(i, |w, h| format!("P6\n{h} {w}\n255\n"), bytes(i))
            });
        },
    },
    Wrong {
        mistake: "P3, the format of numbers in words",
        says: r#"not "P3\n"#,
        check: |c| {
            check(c, |i| {
                file(i, |w, h| format!("P3\n{w} {h}\n255\n"), bytes(i))
            });
        },
    },
    Wrong {
        mistake: "no line of the greatest value",
        says: r#"begins with "P6\n3 2\n255\n", not "P6\n3 2\n\n"#,
        check: |c| check(c, |i| file(i, |w, h| format!("P6\n{w} {h}\n"), bytes(i))),
    },
    Wrong {
        mistake: "no line feed after 255",
        says: "red in column 0 and row 0 of a picture of 3x2: expected 10, got 13",
        check: |c| check(c, |i| file(i, |w, h| format!("P6\n{w} {h}\n255"), bytes(i))),
    },
    Wrong {
        mistake: "a blank line before the pixels",
        says: "bytes of the file of a picture of 3x2: expected 29, got 30",
        check: |c| {
            check(c, |i| {
                file(i, |w, h| format!("P6\n{w} {h}\n255\n\n"), bytes(i))
            });
        },
    },
    Wrong {
        mistake: "the lowest row first",
        says: "red in column 0 and row 0 of a picture of 3x2: expected 10",
        check: |c| {
            check(c, |i| {
                let row = 3 * i.size().width() as usize;
                let upside_down = bytes(i).rchunks(row).flatten().copied().collect();
                file(i, right_header, upside_down)
            });
        },
    },
    Wrong {
        mistake: "blue before red",
        says: "red in column 0 and row 0 of a picture of 3x2: expected 10, got 32",
        check: |c| {
            check(c, |i| {
                let bgr = |rgb: &[u8]| [rgb[2], rgb[1], rgb[0]];
                file(i, right_header, bytes(i).chunks(3).flat_map(bgr).collect())
            });
        },
    },
    Wrong {
        mistake: "pixels as text",
        says: "bytes of the file",
        check: |c| {
            check(c, |i| {
                let text = |byte: u8| format!("{byte} ").into_bytes();
                file(
                    i,
                    right_header,
                    bytes(i).into_iter().flat_map(text).collect(),
                )
            });
        },
    },
];
