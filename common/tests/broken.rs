//! Damaged files, small files that announce a huge picture, and those whose data unpack
//! to hundreds of megabytes: opening one prints nothing and takes little memory.
//!
//! A process of its own, because the test replaces the panic hook and measures the memory.

use std::io::Cursor;
use std::panic;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use common::{Color, picture_file};
use image::{ImageFormat, RgbImage};

/// Messages of panics.
static MESSAGES: AtomicUsize = AtomicUsize::new(0);

/// A bound for opening these files: 16 MiB for metadata, and copies of files of at most
/// 1.7 MB. Unpacked they have 256 MiB.
const ENOUGH: u64 = 32 << 20;

/// The peak of this process's memory in bytes; none on systems that do not report it.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let mut lines = status.lines();
    let line = lines.find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix(" kB")?.parse().ok()?;
    Some(kibibytes << 10)
}

/// A grey PNG of this size with these chunks before the pixels.
fn png(width: u32, height: u32, chunks: &[([u8; 4], Vec<u8>)], pixels: &[u8]) -> Vec<u8> {
    let [width, height] = [width, height].map(u32::to_be_bytes);
    let header = [&width[..], &height, &[8, 0, 0, 0, 0]].concat();
    let mut file = b"\x89PNG\r\n\x1A\n".to_vec();
    write_chunk(&mut file, *b"IHDR", &header);
    for (name, data) in chunks {
        write_chunk(&mut file, *name, data);
    }
    write_chunk(&mut file, *b"IDAT", pixels);
    write_chunk(&mut file, *b"IEND", &[]);
    file
}

/// Length, name, data and check sum (PNG specification, 5.3).
fn write_chunk(file: &mut Vec<u8>, name: [u8; 4], data: &[u8]) {
    let named = [&name, data].concat();
    let shift = |sum: u32| (sum >> 1) ^ ((sum & 1) * 0xEDB8_8320);
    let sum = named.iter().fold(!0, |sum, byte| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| shift(sum))
    });
    file.extend((data.len() as u32).to_be_bytes());
    file.extend(named);
    file.extend((!sum).to_be_bytes());
}

/// A zlib stream (RFC 1950, 1951) of 1 + 258 `times` zeros: a literal, and then 13 bits
/// for each repetition of it.
fn zeros(times: usize) -> Vec<u8> {
    let (literal, again, end) = ("00110000", "1100010100000", "0000000");
    let bits = ["110", literal, &again.repeat(times), end].concat();
    let byte = |bits: &[u8]| {
        bits.iter()
            .rev()
            .fold(0, |byte, bit| byte << 1 | (bit - b'0'))
    };
    let packed = bits.as_bytes().chunks(8).map(byte);
    // Adler's check sum of n zeros is 1 and n.
    let count = (1 + 258 * times) as u32 % 65_521;
    let sum = (count << 16 | 1).to_be_bytes();
    [0x78, 0x01].into_iter().chain(packed).chain(sum).collect()
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

/// The beginning of a JPEG file: one component of 8 bits, and this size.
fn jpeg(width: u16, height: u16) -> Vec<u8> {
    let [width, height] = [width, height].map(u16::to_be_bytes);
    let frame = [
        &[0xFF, 0xC0, 0, 11, 8],
        &height[..],
        &width,
        &[1, 1, 0x11, 0],
    ]
    .concat();
    let quantized = [&[0xFF, 0xDB, 0, 67, 0][..], &[1; 64]].concat();
    let scan = [0xFF, 0xDA, 0, 8, 1, 1, 0, 0, 63, 0];
    [&[0xFF, 0xD8][..], &quantized, &frame, &scan].concat()
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
    let (bomb, dot) = (zeros((256 << 20) / 258), zeros(1));
    let grey = |side, pixels: &[u8]| png(side, side, &[], pixels);
    let packed = |name, head: &[u8]| png(1, 1, &[(name, [head, &bomb].concat())], &dot);
    let too_large = "at most 8192x8192 in all";
    let before = peak();
    for (bytes, reason) in [
        (grey(0x7FFF_FFFF, &dot), "more memory than the largest"),
        (grey(32_768, &dot), too_large),
        (grey(8192, &dot), "not have enough data"),
        (bmp(i32::MAX, i32::MAX), "too large"),
        (bmp(i32::MAX, i32::MIN), "too large"),
        (bmp(65_535, 1), too_large),
        (bmp(30_000, 30_000), too_large),
        (bmp(8192, 8192), "ends too early"),
        (bmp(8192, -8192), "ends too early"),
        (bmp(-1, 1), "Negative width"),
        (jpeg(65_535, 65_535), too_large),
        (jpeg(32_768, 32_768), too_large),
        (jpeg(8192, 8192), "damaged"),
        (damaged_jpeg(), "cannot open bad: the file is damaged"),
    ] {
        let opened = picture_file::open_bytes(Path::new("bad"), &bytes);
        let said = opened.map(|image| image.size()).unwrap_err().to_string();
        assert!(said.contains(reason), "{said}");
    }
    // Data packed beside the pixels, or after them, does not count as pixels.
    for bytes in [
        grey(1, &bomb),
        packed(*b"iCCP", b"profile\0\0"),
        packed(*b"zTXt", b"text\0\0"),
        packed(*b"iTXt", b"text\0\x01\0\0\0"),
    ] {
        let image = picture_file::open_bytes(Path::new("good"), &bytes).unwrap();
        assert_eq!(image.pixels(), [Color::BLACK]);
    }
    if let (Some(before), Some(after)) = (before, peak()) {
        let taken = after - before;
        assert!(taken < ENOUGH, "{taken} bytes");
    }
    assert_eq!(MESSAGES.load(Ordering::Relaxed), 0);
    assert!(panic::catch_unwind(|| panic!("ours")).is_err());
    assert_eq!(MESSAGES.load(Ordering::Relaxed), 1);
}
