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

/// The BMP file of one pixel, with another size in its header.
fn bmp(width: i32, height: i32) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let pixel = image::RgbImage::new(1, 1);
    pixel.write_to(&mut bytes, ImageFormat::Bmp).unwrap();
    let mut bytes = bytes.into_inner();
    bytes[18..22].copy_from_slice(&width.to_le_bytes());
    bytes[22..26].copy_from_slice(&height.to_le_bytes());
    bytes
}

/// Pixel (x, y) of each of these files is (6 x, 10 y, 128): the pictures are 40 wide and 24 high.
/// They have ten scans that add bits, parts that can be decoded alone, a scan for each component
/// with halved chroma, and chroma that is denser than luma.
const GRADIENTS: [&[u8]; 4] = [
    include_bytes!("tests/progressive.jpg"),
    include_bytes!("tests/restarts.jpg"),
    include_bytes!("tests/scans.jpg"),
    include_bytes!("tests/dense-chroma.jpg"),
];

/// The picture of a file, or the reason why it does not open.
fn opened(bytes: &[u8]) -> Result<Image, String> {
    let opened = open_bytes(Path::new("a"), bytes);
    opened.map_err(|error| error.to_string().replace("cannot open a: ", ""))
}

/// Asserts that pixels have these bytes, each within 7: the quality of the files is 95, and their
/// chroma has half the size.
fn assert_bytes(picture: &Image, size: [u32; 2], color: impl Fn(u8, u8) -> [u8; 3]) {
    let expected = Image::from_fn(Size::new(size[0], size[1]).unwrap(), |x, y| {
        Color::from_bytes(color(x as u8, y as u8))
    })
    .unwrap();
    assert_eq!(picture.size(), expected.size());
    for (a, b) in picture.pixels().iter().zip(expected.pixels()) {
        let difference = (*a - *b).map(f64::abs).largest_channel();
        assert!(difference < 7.5 / 255.0, "{a:?} for {b:?}");
    }
}

#[test]
fn jpeg_of_every_order_and_sampling_shows_its_picture_and_is_refused_if_cut_off() {
    let color = |x, y| [6 * x, 10 * y, 128];
    for whole in GRADIENTS {
        assert_bytes(&opened(whole).unwrap(), [40, 24], color);
        for end in 3..whole.len() {
            assert_eq!(opened(&whole[..end]).unwrap_err(), ENDS_TOO_EARLY, "{end}");
        }
    }
    let of_inks = opened(include_bytes!("tests/cmyk.jpg")).unwrap();
    assert_bytes(&of_inks, [40, 24], color);
    let turned = opened(include_bytes!("tests/turned.jpg")).unwrap();
    assert_bytes(&turned, [24, 40], |x, y| color(y, 23 - x));
}

/// A file without the segments of a marker, and with others after its beginning.
fn with_segments(file: &[u8], removed: u8, added: &[u8]) -> Vec<u8> {
    let (mut bytes, mut rest) = ([&file[..2], added].concat(), &file[2..]);
    while rest[1] != 0xDA {
        let length = 2 + usize::from(u16::from_be_bytes([rest[2], rest[3]]));
        let (segment, others) = rest.split_at(length);
        if segment[1] != removed {
            bytes.extend(segment);
        }
        rest = others;
    }
    bytes.extend(rest);
    bytes
}

/// Components 1, 2 and 3 are red, green and blue if Adobe's marker says so, and nothing says JFIF. The file
/// stores the luma and chroma of its gradient, by the formulas of JFIF.
#[test]
fn the_marker_of_adobe_says_what_the_components_are() {
    let adobe = b"\xFF\xEE\0\x0EAdobe\0\x64\0\0\0\0\0";
    let color = |x, y| [6 * x, 10 * y, 128];
    let stored = |x, y| {
        let [r, g, b] = color(x, y).map(f64::from);
        [
            0.299 * r + 0.587 * g + 0.114 * b,
            128.0 - 0.168_736 * r - 0.331_264 * g + 0.5 * b,
            128.0 + 0.5 * r - 0.418_688 * g - 0.081_312 * b,
        ]
        .map(|value| value.round() as u8)
    };
    let ycbcr = GRADIENTS[1];
    let rgb = opened(&with_segments(ycbcr, 0xE0, adobe)).unwrap();
    assert_bytes(&rgb, [40, 24], stored);
    let jfif = opened(&with_segments(ycbcr, 0, adobe)).unwrap();
    assert_bytes(&jfif, [40, 24], color);

    // Adobe stores the light that inks leave, here all of that which is not black; others store the inks.
    let inks = with_segments(include_bytes!("tests/cmyk.jpg"), 0xEE, &[]);
    assert_bytes(&opened(&inks).unwrap(), [40, 24], |_, _| [0, 0, 0]);
}

/// The marker of the end of a picture.
const END: [u8; 2] = [0xFF, 0xD9];

/// What may stand behind the end of a picture: a second one follows the first in pictures of two lenses.
const BEHIND: [&[u8]; 4] = [b"", b"\n", &[0; 40], GRADIENTS[2]];

/// A scan that lacks data is no whole picture. A progressive file that ends behind any scan is one.
#[test]
fn a_jpeg_that_is_cut_is_refused_also_with_the_marker_of_an_end() {
    for whole in &GRADIENTS[1..] {
        for behind in BEHIND {
            let with_more = [whole, behind].concat();
            assert_eq!(opened(&with_more), opened(whole));
            // The length of a header that is cut may lead into a second picture, which then opens.
            let first_cut = if behind.is_empty() {
                3
            } else {
                whole
                    .windows(2)
                    .rposition(|pair| pair == [0xFF, 0xDA])
                    .unwrap()
            };
            for end in first_cut..whole.len() - 2 {
                let cut = [&whole[..end], &END, behind].concat();
                assert!(opened(&cut).is_err(), "{end} of {}", whole.len());
            }
        }
    }
}

/// The file of a picture whose frame is of another process, with this many bits per channel. Baseline pictures are
/// read as extended ones (0xC1) of 8 bits.
fn with_frame(file: &[u8], process: u8, bits: u8) -> Vec<u8> {
    let mut bytes = file.to_vec();
    let frame = file
        .windows(4)
        .position(|bytes| bytes == [0xFF, 0xC0, 0, 17]);
    let frame = frame.unwrap();
    (bytes[frame + 1], bytes[frame + 4]) = (process, bits);
    bytes
}

/// ITU-T T.81, table B.1, and T.87: lossless, hierarchical and arithmetic frames, and a hierarchical beginning.
#[test]
fn jpeg_of_other_kinds_is_refused_by_its_kind() {
    let file = GRADIENTS[1];
    assert_eq!(opened(&with_frame(file, 0xC1, 8)), opened(file));
    let processes = [
        0xC3, 0xC5, 0xC6, 0xC7, 0xC9, 0xCA, 0xCB, 0xCD, 0xCE, 0xCF, 0xDE, 0xF7,
    ];
    let mut others = processes
        .map(|process| with_frame(file, process, 8))
        .to_vec();
    others.push(with_frame(file, 0xC1, 12));
    others.push(with_frame(file, 0xC3, 16));
    for other in others {
        let error = opened(&other).unwrap_err();
        let expected = "it is of a kind that is not supported (";
        assert!(error.starts_with(expected), "{error}");
    }
}

/// The file of a picture of indices of 2 bits, four in a byte, of which each row has six, with a palette of three
/// colours.
fn with_palette(rows: &[[u8; 2]]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 6, rows.len() as u32);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Two);
    encoder.set_palette(vec![1, 2, 3, 11, 12, 13, 21, 22, 23]);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(rows.as_flattened()).unwrap();
    drop(writer);
    file
}

#[test]
fn a_png_with_pixels_beyond_its_palette_or_its_height_is_refused() {
    // The last two pixels of a second byte are none: they may have any bits.
    let right = [[0b00_01_10_00, 0b10_01_11_11], [0; 2]];
    let picture = opened(&with_palette(&right)).unwrap();
    let reds: Vec<_> = picture.pixels()[..6]
        .iter()
        .map(|color| color.to_bytes()[0])
        .collect();
    assert_eq!(reds, [1, 11, 21, 1, 21, 11]);
    let beyond = with_palette(&[[0; 2], [0, 0b00_11_00_00]]);
    let [two, three] = [2, 3].map(|rows| with_palette(&vec![[0; 2]; rows]));
    // Header and data of two files: the signature and the first chunk have 33 bytes.
    let with_more = [&two[..33], &three[33..]].concat();
    for (file, fault) in [
        (
            beyond,
            "it has pixels of colours that its palette lacks; save",
        ),
        (
            with_more,
            "it has more rows of pixels than its header says; save",
        ),
    ] {
        let error = opened(&file).unwrap_err();
        assert!(error.starts_with(fault), "{error}");
    }
}

#[test]
fn a_file_that_is_no_whole_picture_is_refused_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let whole = std::fs::read(saved(folder.path())).unwrap();
    let mut flipped = whole.clone();
    let data = whole.windows(4).position(|name| name == b"IDAT").unwrap();
    flipped[data + 12] ^= 1;
    let mut bmp_of_inks = bmp(1, 1);
    bmp_of_inks[30] = 11;
    let [quantisation, huffman] =
        [0xDB, 0xC4].map(|tables| with_segments(GRADIENTS[0], tables, &[]));
    for (bytes, reason) in [
        (&quantisation[..], "it lacks tables that its pixels need"),
        (&huffman, "it lacks tables that its pixels need"),
        (&b"\x01\x02"[..], "it is no PNG, JPEG or BMP picture"),
        (b"", "it is no PNG, JPEG or BMP picture"),
        (
            b"GIF89a\x01\0",
            "it is image/gif, and only PNG, JPEG and BMP",
        ),
        (b"RIFF\x24\0\0\0WEBPVP8 ", "it is image/webp, and only PNG"),
        (&flipped, "its decoder refuses it ("),
        (&whole[..whole.len() / 2], "the file ends too early"),
        (&bmp(i32::MAX, i32::MIN), "its decoder refuses it ("),
        (
            &bmp(65_535, 1),
            "size is 65535x1, but must be from 1 to 32768 pixels a side",
        ),
        (&bmp(30_000, 30_000), "size is 30000x30000, but must be"),
        (&bmp(8192, -8192), "the file ends too early"),
        (&bmp_of_inks, "it is of a kind that is not supported ("),
        (
            include_bytes!("tests/arithmetic.jpg"),
            "it is of a kind that is not supported (unsupported JPEG feature: \
             ArithmeticEntropyCoding); save it as PNG",
        ),
    ] {
        let error = opened(bytes).unwrap_err();
        assert!(error.starts_with(reason), "{error}");
    }
    // The last twelve bytes only mark the end of the picture.
    for length in 0..whole.len() - 12 {
        assert!(opened(&whole[..length]).is_err(), "{length} bytes");
    }
    // A sparse file: it occupies no space on the disk.
    let long = folder.path().join("long.jpg");
    let file = std::fs::File::create(&long).unwrap();
    file.set_len(MAX_FILE_BYTES + 1).unwrap();
    let error = open(&long).unwrap_err().to_string();
    assert!(
        error.ends_with("it has more than 1073741824 bytes"),
        "{error}"
    );
}
