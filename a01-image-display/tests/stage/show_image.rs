//! `ShowImage` with good files and with all kinds of bad ones.

use std::fs;
use std::io::Cursor;
use std::path::Path;

use a01_image_display::ShowImage;
use common::{Color, Image, Size};
use image::{ImageFormat, RgbImage};

const TEST_CARD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/test-card.png");

fn test_card() -> Image {
    ShowImage::test_card().unwrap().into_image()
}

fn encoded(picture: &RgbImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut target = Cursor::new(&mut bytes);
    picture.write_to(&mut target, format).unwrap();
    bytes
}

#[test]
fn the_test_card_holds_what_it_is_looked_at_for() {
    let card = test_card();
    assert_eq!(card.size(), Size::COURSE);
    let byte = |x, y| card.get(x, y).unwrap().to_bytes();
    for x in 0..640 {
        assert_eq!((byte(x, 0), byte(x, 479)), ([255; 3], [255; 3]), "border");
    }
    for y in 0..480 {
        assert_eq!((byte(0, y), byte(639, y)), ([255; 3], [255; 3]), "border");
    }
    let bars = [40, 110, 180, 250, 320, 390, 460, 530].map(|x| card.get(x, 90).unwrap());
    let cyan = Color::new(0.0, 1.0, 1.0);
    let expected = [Color::WHITE, Color::YELLOW, cyan, Color::GREEN];
    assert_eq!(bars[..4], expected);
    let expected = [Color::MAGENTA, Color::RED, Color::BLUE, Color::BLACK];
    assert_eq!(bars[4..], expected);
    for step in 0..16 {
        assert_eq!(byte(41 + 35 * step, 205), [17 * step as u8; 3], "ramp");
    }
    for at in (280..370).step_by(2) {
        assert_eq!((byte(200, at), byte(200, at + 1)), ([255; 3], [0; 3]));
    }
    for at in (400..470).step_by(2) {
        assert_eq!((byte(at, 300), byte(at + 1, 300)), ([255; 3], [0; 3]));
    }
    assert_eq!((byte(60, 300), byte(320, 300)), ([128; 3], [188; 3]));
}

#[test]
fn a_file_opens_as_what_it_holds() {
    let opened = ShowImage::open(Path::new(TEST_CARD)).unwrap();
    assert_eq!(opened.into_image(), test_card());
}

#[test]
fn a_jpeg_called_png_opens() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("photo.png");
    let picture = RgbImage::from_pixel(24, 16, image::Rgb([200, 100, 50]));
    fs::write(&path, encoded(&picture, ImageFormat::Jpeg)).unwrap();
    let opened = ShowImage::open(&path).unwrap().into_image();
    assert_eq!(opened.size(), Size::new(24, 16).unwrap());
    for pixel in opened.pixels() {
        // JPEG is lossy; one flat colour survives it almost.
        for (byte, expected) in pixel.to_bytes().into_iter().zip([200_u8, 100, 50]) {
            assert!(byte.abs_diff(expected) <= 3, "{pixel:?}");
        }
    }
}

#[test]
fn what_cannot_be_opened_is_named_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.png");
    let reason = || {
        let error = ShowImage::open(&path).unwrap_err().to_string();
        let named = format!("cannot open {}: ", path.display());
        error.strip_prefix(&named).expect("the path").to_owned()
    };
    assert_eq!(reason(), "there is no such file");

    let card = fs::read(TEST_CARD).unwrap();
    let mut corrupt = card.clone();
    let data = card.windows(4).position(|name| name == b"IDAT").unwrap();
    corrupt[data + 100] ^= 0x10;
    let mut absurd = encoded(&RgbImage::new(1, 1), ImageFormat::Bmp);
    // Width and height in the header of a BMP file.
    absurd[18..22].copy_from_slice(&2_000_000_000_u32.to_le_bytes());
    absurd[22..26].copy_from_slice(&2_000_000_000_u32.to_le_bytes());
    for (bytes, expected) in [
        (Vec::new(), "no PNG, JPEG or BMP"),
        (b"Dear diary".to_vec(), "no PNG, JPEG or BMP"),
        (card[..card.len() / 2].to_vec(), "ends too early"),
        (corrupt, "damaged"),
        (absurd, "too large"),
    ] {
        fs::write(&path, bytes).unwrap();
        assert!(reason().contains(expected), "{}", reason());
    }

    fs::remove_file(&path).unwrap();
    fs::create_dir(&path).unwrap();
    assert_eq!(reason(), "it is a folder, not a picture");
}
