use super::*;
use crate::Transfer;

fn sample() -> Image {
    Image::from_fn(Size::new(20, 10).unwrap(), |x, y| {
        Color::from_bytes([x as u8 * 10, y as u8 * 20, 200])
    })
    .unwrap()
}

fn saved(folder: &Path) -> std::path::PathBuf {
    let path = folder.join("sample.png");
    let image = sample();
    save_png(&path, image.size(), &image.to_rgb8(Transfer::Linear)).unwrap();
    path
}

#[test]
fn a_saved_picture_opens_again_and_no_other_file_is_left() {
    let folder = tempfile::tempdir().unwrap();
    let path = saved(folder.path());
    saved(folder.path());
    assert_eq!(open(&path).unwrap(), sample());
    assert_eq!(folder.path().read_dir().unwrap().count(), 1);
}

#[test]
fn jpeg_and_bmp_open_under_any_name() {
    let folder = tempfile::tempdir().unwrap();
    let image = sample();
    let rgb = image.to_rgb8(Transfer::Linear);
    let buffer = image::RgbImage::from_raw(20, 10, rgb).unwrap();
    for (format, largest_difference) in [
        (image::ImageFormat::Bmp, 0.0),
        // JPEG is lossy, and the colours change fast: the bound is a sixth of the range.
        (image::ImageFormat::Jpeg, 1.0 / 6.0),
    ] {
        let path = folder.path().join("named.png");
        buffer.save_with_format(&path, format).unwrap();
        let opened = open(&path).unwrap();
        assert_eq!(opened.size(), image.size());
        for (a, b) in opened.pixels().iter().zip(image.pixels()) {
            for channel in (*a - *b).channels() {
                assert!(channel.abs() <= largest_difference, "{format:?}: {channel}");
            }
        }
    }
}

#[test]
fn transparent_pixels_are_blended_with_black() {
    for opacity in [0, 128, 255] {
        let mut png = Cursor::new(Vec::new());
        let white = image::Rgba([255, 255, 255, opacity]);
        let pixel = image::RgbaImage::from_pixel(1, 1, white);
        pixel.write_to(&mut png, image::ImageFormat::Png).unwrap();
        let opened = open_bytes(Path::new("a.png"), png.get_ref()).unwrap();
        let expected = Color::gray(f64::from(opacity) / 255.0);
        assert_eq!(opened.pixels(), [expected]);
    }
}

#[test]
fn a_file_that_is_no_whole_picture_is_refused_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let whole = std::fs::read(saved(folder.path())).unwrap();
    let mut flipped = whole.clone();
    let data = whole.windows(4).position(|name| name == b"IDAT").unwrap();
    flipped[data + 12] ^= 1;
    for (bytes, reason) in [
        (&b"\x01\x02"[..], "it is no PNG, JPEG or BMP picture"),
        (&flipped, "the file is damaged ("),
        (&whole[..whole.len() / 2], "the file ends too early"),
    ] {
        let error = open_bytes(Path::new("bad.png"), bytes).unwrap_err();
        let start = format!("cannot open bad.png: {reason}");
        assert!(error.to_string().starts_with(&start), "{error}");
    }
    // The last twelve bytes only mark the end of the picture.
    for length in 0..whole.len() - 12 {
        let cut = open_bytes(Path::new("cut.png"), &whole[..length]);
        assert!(cut.is_err(), "{length} bytes of {}", whole.len());
    }
}

/// A JPEG of one scan, in parts that can be decoded alone.
const RESTARTS: &[u8] = include_bytes!("tests/restarts.jpg");
/// A JPEG of ten scans, each of which adds bits to the coefficients.
const PROGRESSIVE: &[u8] = include_bytes!("tests/progressive.jpg");

/// The picture of a file, or the reason why it does not open.
fn opened(bytes: &[u8]) -> Result<Image, String> {
    let opened = open_bytes(Path::new("a"), bytes);
    opened.map_err(|error| error.to_string().replace("cannot open a: ", ""))
}

/// The largest difference of a channel.
fn difference(a: &Image, b: &Image) -> f64 {
    let pairs = a.pixels().iter().zip(b.pixels());
    let differences = pairs.map(|(a, b)| (*a - *b).map(f64::abs).largest_channel());
    differences.fold(0.0, f64::max)
}

#[test]
fn a_jpeg_that_is_cut_off_is_refused_unless_only_its_end_mark_is_missing() {
    let mut plain = Vec::new();
    let rgb = image::RgbImage::from_raw(20, 10, sample().to_rgb8(Transfer::Linear)).unwrap();
    let target = &mut Cursor::new(&mut plain);
    rgb.write_to(target, image::ImageFormat::Jpeg).unwrap();
    for whole in [&plain, RESTARTS, PROGRESSIVE] {
        let picture = opened(whole).unwrap();
        let without_end = &whole[..whole.len() - 2];
        for tail in [&[][..], &[0xFF], &[0; 300]] {
            for file in [without_end, whole] {
                let again = opened(&[file, tail].concat()).unwrap();
                assert_eq!(difference(&again, &picture), 0.0);
            }
        }
        for end in 3..without_end.len() {
            for zeros in [0, 300] {
                match opened(&[&whole[..end], &vec![0; zeros]].concat()) {
                    // The last bits may change no byte of a pixel by more than its rounding.
                    Ok(cut) => assert!(difference(&cut, &picture) < 1.5 / 255.0, "{end} bytes"),
                    Err(reason) => assert_eq!(reason, ENDS_TOO_EARLY, "{end} bytes, {zeros}"),
                }
            }
        }
        let half = &whole[..whole.len() * 9 / 10];
        assert!(opened(half).is_err());
        if whole != PROGRESSIVE {
            let ended = [half, &[0xFF, 0xD9]].concat();
            assert_eq!(opened(&ended).unwrap_err(), ENDS_TOO_EARLY);
        }
    }
}

#[test]
fn pictures_of_unsupported_kinds_are_called_by_their_kind() {
    let frame = RESTARTS
        .windows(2)
        .position(|pair| pair == [0xFF, 0xC0])
        .unwrap();
    let jpeg = |offset: usize, value: u8| {
        let mut bytes = RESTARTS.to_vec();
        bytes[frame + offset] = value;
        bytes
    };
    // A header of this size, with a compression and a number of bits per pixel.
    let bmp = |header: u32, compression: u32, bits: u16| {
        let mut bytes = b"BM".to_vec();
        bytes.resize(200, 0);
        bytes[14..18].copy_from_slice(&header.to_le_bytes());
        bytes[18..26].copy_from_slice(&[4, 0, 0, 0, 4, 0, 0, 0]);
        bytes[26..30].copy_from_slice(&[1, 0, bits as u8, 0]);
        bytes[30..34].copy_from_slice(&compression.to_le_bytes());
        bytes
    };
    for (bytes, kind) in [
        (
            include_bytes!("tests/arithmetic.jpg").to_vec(),
            "a JPEG picture with arithmetic coding",
        ),
        (jpeg(4, 12), "a JPEG picture with 12 bits per channel"),
        (jpeg(1, 0xC3), "a lossless JPEG picture"),
        (jpeg(1, 0xC5), "a hierarchical JPEG picture"),
        (
            jpeg(1, 0xCB),
            "a lossless JPEG picture with arithmetic coding",
        ),
        (jpeg(1, 0xF7), "a JPEG-LS picture"),
        (bmp(40, 6, 32), "a BMP picture with alpha bitfields"),
        (bmp(124, 4, 0), "a BMP picture that contains a JPEG"),
        (bmp(40, 5, 0), "a BMP picture that contains a PNG"),
        (bmp(40, 11, 32), "a BMP picture of CMYK colours"),
        (bmp(40, 0, 64), "a BMP picture with 64 bits per pixel"),
        (bmp(64, 4, 24), "a BMP picture in RLE24, of OS/2"),
        (bmp(64, 3, 1), "a BMP picture in Huffman code, of OS/2"),
    ] {
        assert_eq!(opened(&bytes).unwrap_err(), kind::not_supported(kind));
    }
}

#[test]
fn files_of_other_kinds_are_called_by_their_kind() {
    for (bytes, kind) in [
        (&b"GIF89a\x01\0"[..], "a GIF picture"),
        (b"II*\0\x08\0\0\0", "a TIFF picture"),
        (b"RIFF\x24\0\0\0WEBPVP8 ", "a WebP picture"),
        (b"\0\0\0\x20ftypheic\0\0", "a HEIC picture"),
        (b"\0\0\0\x20ftypavif\0\0", "an AVIF picture"),
        (b"\n<!DOCTYPE html>\n<html>", "a web page (HTML)"),
        (b"<?xml version=\"1.0\"?>\n<svg>", "an SVG drawing"),
        (b"%PDF-1.7", "a PDF document"),
        (b"\xEF\xBB\xBFGr\xC3\xBC\xC3\x9Fe", "a text"),
        (b"", "an empty file"),
        (&[0; 64], "a file of zeros"),
    ] {
        let reason = format!("it is {kind}, and only PNG, JPEG and BMP pictures open");
        assert_eq!(opened(bytes).unwrap_err(), reason);
    }
}

#[test]
fn a_file_that_cannot_be_read_is_refused_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    saved(folder.path());
    // A sparse file: it occupies no space on the disk.
    let mut file = File::create(path("long.jpg")).unwrap();
    io::Write::write_all(&mut file, &[0xFF, 0xD8, 0xFF]).unwrap();
    file.set_len(LONGEST_FILE + 1).unwrap();
    for (path, reason) in [
        (path("."), "it is a folder, not a picture"),
        (path("a.png"), "there is no such file"),
        (path("long.jpg"), "it is longer than 1 GiB"),
        #[cfg(unix)]
        (path("sample.png/a.png"), "Not a directory"),
    ] {
        let error = open(&path).unwrap_err().to_string();
        let start = format!("cannot open {}: {reason}", path.display());
        assert!(error.starts_with(&start), "{error}");
    }
}
