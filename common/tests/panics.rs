//! Panics of the JPEG decoder print nothing, and all others print their message.
//! The only test of its process, because it replaces the panic hook.

use std::io::Cursor;
use std::panic;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use common::picture_file;

static MESSAGES: AtomicUsize = AtomicUsize::new(0);

/// A JPEG file at which the decoder panics. According to its header, the second of three
/// components has two by three values for each of the others, but only the data of the
/// first one follow.
fn jpeg() -> Vec<u8> {
    let mut jpeg = Vec::new();
    let target = &mut Cursor::new(&mut jpeg);
    let picture = image::RgbImage::new(20, 17);
    picture.write_to(target, image::ImageFormat::Jpeg).unwrap();
    let find = |bytes: &[u8], part: &[u8]| {
        let start = bytes.windows(part.len()).position(|window| window == part);
        start.expect("the part")
    };
    let components = find(&jpeg, &[3, 1, 0x11, 0, 2, 0x11, 1, 3, 0x11, 1]);
    jpeg[components + 5] = 0x23;
    let scan = [0xFF, 0xDA, 0, 12, 3, 1, 0, 2, 0x11, 3, 0x11];
    let start = find(&jpeg, &scan);
    jpeg.splice(start..start + scan.len(), [0xFF, 0xDA, 0, 8, 1, 1, 0]);
    jpeg
}

#[test]
fn a_panic_of_the_decoder_prints_nothing() {
    panic::set_hook(Box::new(|_| {
        MESSAGES.fetch_add(1, Ordering::Relaxed);
    }));
    let jpeg = jpeg();
    for _ in 0..2 {
        let error = picture_file::open_bytes(Path::new("odd.jpg"), &jpeg).unwrap_err();
        let expected = "cannot open odd.jpg: the file is damaged";
        assert_eq!(error.to_string(), expected);
    }
    assert_eq!(MESSAGES.load(Ordering::Relaxed), 0);
    assert!(panic::catch_unwind(|| panic!("ours")).is_err());
    assert_eq!(MESSAGES.load(Ordering::Relaxed), 1);
}
