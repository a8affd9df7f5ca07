//! Small files that announce a huge picture, or whose data unpack to hundreds of
//! megabytes: opening one takes little memory. The only test of its process, because it
//! measures the memory of the process.

use std::path::Path;

use common::{Color, picture_file};

/// A bound for opening these files: 16 MiB for metadata, and copies of files of at most
/// 1.7 MB. Unpacked they have 256 MiB.
const ENOUGH: u64 = 32 << 20;

/// The peak of this process's memory in bytes; none on systems that do not report it.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix(" kB")?.parse().ok()?;
    Some(kibibytes << 10)
}

/// The check sum of a PNG chunk (ISO 3309).
fn crc(bytes: &[u8]) -> u32 {
    let bit = |crc: u32, _| crc >> 1 ^ (0xEDB8_8320 & (crc & 1).wrapping_neg());
    let byte = |crc: u32, byte: &u8| (0..8).fold(crc ^ u32::from(*byte), bit);
    !bytes.iter().fold(!0, byte)
}

fn chunk(name: [u8; 4], data: &[u8]) -> Vec<u8> {
    let named = [&name, data].concat();
    let (length, crc) = (data.len() as u32, crc(&named));
    [&length.to_be_bytes(), &named[..], &crc.to_be_bytes()].concat()
}

/// A grey PNG of this size with these chunks before the pixels.
fn png(width: u32, height: u32, chunks: &[Vec<u8>], pixels: &[u8]) -> Vec<u8> {
    let [width, height] = [width, height].map(u32::to_be_bytes);
    let header = [&width[..], &height, &[8, 0, 0, 0, 0]].concat();
    [
        b"\x89PNG\r\n\x1A\n".to_vec(),
        chunk(*b"IHDR", &header),
        chunks.concat(),
        chunk(*b"IDAT", pixels),
        chunk(*b"IEND", &[]),
    ]
    .concat()
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

/// A BMP header of 24 bits a pixel and this size, and one pixel.
fn bmp(width: i32, height: i32) -> Vec<u8> {
    let [width, height] = [width, height].map(i32::to_le_bytes);
    let file = [0, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0];
    let rest = [[0; 12], [0; 12]].concat();
    [
        b"BM",
        &file[..],
        &[40, 0, 0, 0],
        &width,
        &height,
        &[1, 0, 24, 0],
        &rest[4..],
        &[0; 8],
    ]
    .concat()
}

/// The beginning of a JPEG file: one component of 8 bits, and this size.
fn jpeg(width: u16, height: u16) -> Vec<u8> {
    let [width, height] = [width, height].map(u16::to_be_bytes);
    let frame = [
        &[0xFF, 0xC0, 0, 11, 8][..],
        &height,
        &width,
        &[1, 1, 0x11, 0],
    ]
    .concat();
    let quantized = [&[0xFF, 0xDB, 0, 67, 0][..], &[1; 64]].concat();
    let scan = [0xFF, 0xDA, 0, 8, 1, 1, 0, 0, 63, 0];
    [&[0xFF, 0xD8][..], &quantized, &frame, &scan].concat()
}

#[test]
fn no_file_takes_memory_that_its_picture_does_not_need() {
    let (bomb, dot) = (zeros((256 << 20) / 258), zeros(1));
    let packed = |name: [u8; 4], head: &[u8]| vec![chunk(name, &[head, &bomb].concat())];
    let grey = |side, pixels: &[u8]| png(side, side, &[], pixels);
    let with = |chunks: Vec<_>| png(1, 1, &chunks, &dot);
    let (too_many, too_large) = ("from 1 to 32768 pixels a side", "at most 8192x8192 in all");
    let before = peak();
    for (bytes, reason) in [
        (
            grey(0x7FFF_FFFF, &dot),
            "more memory than the largest pictures",
        ),
        (grey(32_768, &dot), too_large),
        (grey(8192, &dot), "not have enough data"),
        (bmp(i32::MAX, i32::MAX), "too large"),
        (bmp(i32::MAX, i32::MIN), "too large"),
        (bmp(65_535, 1), too_many),
        (bmp(30_000, 30_000), too_large),
        (bmp(8192, 8192), "ends too early"),
        (bmp(8192, -8192), "ends too early"),
        (bmp(-1, 1), "Negative width"),
        (jpeg(65_535, 65_535), too_many),
        (jpeg(32_768, 32_768), too_large),
        (jpeg(8192, 8192), "damaged"),
    ] {
        let opened = picture_file::open_bytes(Path::new("bad"), &bytes);
        let said = opened.map(|image| image.size()).unwrap_err().to_string();
        assert!(said.contains(reason), "{said}");
    }
    // Data packed beside the pixels, or after them, does not count as pixels.
    for bytes in [
        grey(1, &bomb),
        with(packed(*b"iCCP", b"profile\0\0")),
        with(packed(*b"zTXt", b"text\0\0")),
        with(packed(*b"iTXt", b"text\0\x01\0\0\0")),
    ] {
        let image = picture_file::open_bytes(Path::new("good"), &bytes).unwrap();
        assert_eq!(image.pixels(), [Color::BLACK]);
    }
    if let (Some(before), Some(after)) = (before, peak()) {
        let taken = after - before;
        assert!(taken < ENOUGH, "{taken} bytes");
    }
}
