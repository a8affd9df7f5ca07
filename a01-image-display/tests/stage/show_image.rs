//! The test card. `common::picture_file` tests good and bad files.

use std::path::Path;

use a01_image_display::ShowImage;
use common::{Color, Size};

const TEST_CARD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/test-card.png");

#[test]
fn the_test_card_has_border_bars_ramp_lines_and_greys() {
    let card = ShowImage::test_card().unwrap().into_image();
    let opened = ShowImage::open(Path::new(TEST_CARD)).unwrap();
    assert_eq!(opened.into_image(), card);
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
