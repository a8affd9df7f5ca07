//! Damaged files, and small files that announce a huge picture: opening one prints nothing
//! and takes little memory.
//!
//! A process of its own, because the test replaces the panic hook and measures the memory.

use std::io::Cursor;
use std::panic;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use common::picture_file;
use image::{ImageFormat, RgbImage};

/// Messages of panics.
static MESSAGES: AtomicUsize = AtomicUsize::new(0);

/// A bound for opening these files: the metadata that a decoder may allocate, twice.
const ENOUGH: u64 = 32 << 20;

/// The peak of this process's memory in bytes; none on systems that do not report it.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let mut lines = status.lines();
    let line = lines.find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix(" kB")?.parse().ok()?;
    Some(kibibytes << 10)
}

/// The BMP file of one pixel, with another size in its header.
fn bmp(width: i32, height: i32) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let pixel = RgbImage::new(1, 1);
    pixel.write_to(&mut bytes, ImageFormat::Bmp).unwrap();
    let mut bytes = bytes.into_inner();
    bytes[18..22].copy_from_slice(&width.to_le_bytes());
    bytes[22..26].copy_from_slice(&height.to_le_bytes());
    bytes
}

/// A JPEG file at which the decoder panics. According to its header, the second of three
/// components has two by three values for each of the others, but only the data of the
/// first one follow.
fn damaged_jpeg() -> Vec<u8> {
    let mut jpeg = Vec::new();
    let picture = RgbImage::new(20, 17);
    let target = &mut Cursor::new(&mut jpeg);
    picture.write_to(target, ImageFormat::Jpeg).unwrap();
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
fn a_broken_file_prints_nothing_and_takes_little_memory() {
    let loud = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        MESSAGES.fetch_add(1, Ordering::Relaxed);
        loud(info);
    }));
    let before = peak();
    for (bytes, reason) in [
        (bmp(i32::MAX, i32::MIN), "too large"),
        (bmp(65_535, 1), "from 1 to 32768 pixels a side"),
        (bmp(30_000, 30_000), "at most 8192x8192 in all"),
        (bmp(8192, -8192), "ends too early"),
        (bmp(-1, 1), "Negative width"),
        (damaged_jpeg(), "cannot open bad: the file is damaged"),
    ] {
        let opened = picture_file::open_bytes(Path::new("bad"), &bytes);
        let said = opened.map(|image| image.size()).unwrap_err().to_string();
        assert!(said.contains(reason), "{said}");
    }
    if let (Some(before), Some(after)) = (before, peak()) {
        let taken = after - before;
        assert!(taken < ENOUGH, "{taken} bytes");
    }
    assert_eq!(MESSAGES.load(Ordering::Relaxed), 0);
    assert!(panic::catch_unwind(|| panic!("ours")).is_err());
    assert_eq!(MESSAGES.load(Ordering::Relaxed), 1);
}
