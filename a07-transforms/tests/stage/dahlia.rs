//! The picture at the top of the README: one of its rows.

use std::path::Path;

use common::{Settings, Transfer, picture_file};

#[path = "../../examples/dahlia.rs"]
#[expect(dead_code, reason = "the example's own main")]
mod example;

/// A row through the petals, the drops and the mirror.
const ROW: u32 = 420;

#[test]
fn a_row_of_the_picture_is_right() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../book/src/pictures/dahlia.png");
    let picture = picture_file::open(&path).unwrap();
    let stage = example::stage();
    let settings = Settings {
        rows: Some(ROW..ROW + 1),
        ..stage.scenes[0].defaults.clone()
    };
    assert_eq!(picture.size(), settings.size);
    let row = stage.scenes[0].render(&settings, &()).unwrap();
    let expected = picture.to_rgb8(Transfer::Linear);
    let width = 3 * settings.size.width() as usize;
    let start = ROW as usize * width;
    let is_same = row.to_rgb8(Transfer::Srgb) == expected[start..start + width];
    assert!(is_same, "row {ROW} differs from {}", path.display());
}
