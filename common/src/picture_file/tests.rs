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
        (&b"GIF89a"[..], "it is no PNG, JPEG or BMP picture"),
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
