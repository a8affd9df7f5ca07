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

fn reason(path: &Path) -> String {
    open(path).unwrap_err().to_string()
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
fn transparent_pixels_are_black() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("clear.png");
    let clear = image::RgbaImage::from_pixel(1, 1, image::Rgba([255, 255, 255, 0]));
    clear.save(&path).unwrap();
    assert_eq!(open(&path).unwrap().pixels(), [Color::BLACK]);
}

#[test]
fn files_that_are_no_pictures_are_refused_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.png");
    assert!(reason(&path).contains("bad.png"), "{}", reason(&path));

    std::fs::write(&path, "").unwrap();
    assert!(
        reason(&path).contains("no PNG, JPEG or BMP"),
        "{}",
        reason(&path)
    );
    std::fs::write(&path, "this is text, not a picture").unwrap();
    assert!(
        reason(&path).contains("no PNG, JPEG or BMP"),
        "{}",
        reason(&path)
    );
    std::fs::write(&path, b"GIF89a\x01\0\x01\0\0\0\0;").unwrap();
    assert!(
        reason(&path).contains("no PNG, JPEG or BMP"),
        "{}",
        reason(&path)
    );
    assert!(open(folder.path()).is_err(), "a folder");
}

#[test]
fn a_file_cut_anywhere_is_refused_and_does_not_panic() {
    let folder = tempfile::tempdir().unwrap();
    let whole = std::fs::read(saved(folder.path())).unwrap();
    let path = folder.path().join("cut.png");
    // The last twelve bytes only mark the end of the picture.
    for length in 0..whole.len() - 12 {
        std::fs::write(&path, &whole[..length]).unwrap();
        assert!(open(&path).is_err(), "{length} bytes of {}", whole.len());
    }
}

#[test]
fn a_flipped_bit_in_the_pixels_is_noticed() {
    let folder = tempfile::tempdir().unwrap();
    let path = saved(folder.path());
    let mut bytes = std::fs::read(&path).unwrap();
    let data = bytes.windows(4).position(|name| name == b"IDAT").unwrap();
    bytes[data + 12] ^= 1;
    std::fs::write(&path, bytes).unwrap();
    assert!(reason(&path).contains("damaged"), "{}", reason(&path));
}

#[test]
fn a_header_of_a_huge_picture_is_refused_before_memory_is_allocated() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("huge.bmp");
    let mut bmp = Vec::new();
    image::RgbImage::new(1, 1)
        .write_to(&mut Cursor::new(&mut bmp), image::ImageFormat::Bmp)
        .unwrap();
    // Width and height in the header of a BMP file.
    bmp[18..22].copy_from_slice(&30_000_u32.to_le_bytes());
    bmp[22..26].copy_from_slice(&30_000_u32.to_le_bytes());
    std::fs::write(&path, bmp).unwrap();
    assert!(
        reason(&path).contains("at most 8192x8192"),
        "{}",
        reason(&path)
    );
}

/// The file is sparse: it has no content and occupies no space on the disk.
#[test]
#[cfg(unix)]
fn a_file_that_is_too_long_is_not_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("long.jpg");
    let mut file = File::create(&path).unwrap();
    io::Write::write_all(&mut file, &[0xFF, 0xD8, 0xFF]).unwrap();
    file.set_len(LONGEST_FILE + 1).unwrap();
    assert!(reason(&path).ends_with("it is longer than 1 GiB"));
}

#[test]
fn a_picture_in_memory_opens_like_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let bytes = std::fs::read(saved(folder.path())).unwrap();
    let name = Path::new("card.png");
    assert_eq!(open_bytes(name, &bytes).unwrap(), sample());
    let error = open_bytes(name, &bytes[..40]).unwrap_err().to_string();
    assert!(error.starts_with("cannot open card.png: "), "{error}");
}

#[test]
fn errors_name_folders_and_missing_files() {
    let folder = tempfile::tempdir().unwrap();
    assert!(reason(folder.path()).ends_with("it is a folder, not a picture"));
    assert!(reason(&folder.path().join("a.png")).ends_with("there is no such file"));
}

#[test]
#[cfg(unix)]
fn other_errors_of_the_system_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let inside_a_file = saved(folder.path()).join("a.png");
    assert!(reason(&inside_a_file).contains("Not a directory"));
}

#[test]
fn a_folder_that_is_missing_is_named_and_not_made() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("missing").join("a.png");
    let size = Size::new(1, 1).unwrap();
    let error = save_png(&path, size, &[0; 3]).unwrap_err().to_string();
    assert!(error.contains("there is no folder"), "{error}");
    assert!(!folder.path().join("missing").exists());
}

#[test]
fn a_picture_that_cannot_be_renamed_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    std::fs::create_dir(&path).unwrap();
    let size = Size::new(1, 1).unwrap();
    assert!(save_png(&path, size, &[0; 3]).is_err());
    assert_eq!(folder.path().read_dir().unwrap().count(), 1);
}

/// The opacity of white is 128 of 255.
#[test]
fn half_transparent_pixels_are_half_as_bright() {
    let mut png = Cursor::new(Vec::new());
    let half = image::RgbaImage::from_pixel(1, 1, image::Rgba([255, 255, 255, 128]));
    half.write_to(&mut png, image::ImageFormat::Png).unwrap();
    let opened = open_bytes(Path::new("half.png"), &png.into_inner()).unwrap();
    assert_eq!(opened.pixels(), [Color::gray(128.0 / 255.0)]);
}

#[test]
fn an_error_of_the_disk_is_not_reported_as_a_truncated_file() {
    struct Failing<'a>(&'a [u8]);
    impl io::Read for Failing<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            match self.0.read(buffer)? {
                0 => Err(io::Error::other("the disk is broken")),
                read => Ok(read),
            }
        }
    }
    impl Seek for Failing<'_> {
        fn seek(&mut self, _: io::SeekFrom) -> io::Result<u64> {
            Ok(0)
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let whole = std::fs::read(saved(folder.path())).unwrap();
    let half = BufReader::new(Failing(&whole[..whole.len() / 2]));
    let error = read(Path::new("a.png"), half).unwrap_err().to_string();
    assert_eq!(error, "cannot open a.png: the disk is broken");
}
