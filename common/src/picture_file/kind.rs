//! Names the kinds of files that are no pictures which open, so that a reader knows what to do.

/// The beginnings of files, and their kinds.
const KINDS: [(&[u8], &str); 35] = [
    (b"GIF87a", "a GIF picture"),
    (b"GIF89a", "a GIF picture"),
    (b"II*\0", "a TIFF picture"),
    (b"MM\0*", "a TIFF picture"),
    (b"II+\0", "a TIFF picture"),
    (b"MM\0+", "a TIFF picture"),
    (b"\0\0\x01\0", "an icon (ICO)"),
    (b"\0\0\x02\0", "a cursor (CUR)"),
    (b"8BPS", "a Photoshop picture (PSD)"),
    (b"gimp xcf", "a GIMP picture (XCF)"),
    (b"qoif", "a QOI picture"),
    (b"DDS ", "a DDS picture"),
    (b"farbfeld", "a farbfeld picture"),
    (b"#?RADIANCE", "a Radiance picture (HDR)"),
    (b"#?RGBE", "a Radiance picture (HDR)"),
    (b"\x76\x2F\x31\x01", "an OpenEXR picture"),
    (b"\xFF\x0A", "a JPEG XL picture"),
    (b"\0\0\0\x0CJXL ", "a JPEG XL picture"),
    (b"\0\0\0\x0CjP  ", "a JPEG 2000 picture"),
    (b"\xFF\x4F\xFF\x51", "a JPEG 2000 picture"),
    (b"\x8AMNG", "an MNG picture"),
    (b"\x8BJNG", "a JNG picture"),
    (b"BA", "a list of OS/2 bitmaps"),
    (b"P1", "a PNM picture"),
    (b"P2", "a PNM picture"),
    (b"P3", "a PNM picture"),
    (b"P4", "a PNM picture"),
    (b"P5", "a PNM picture"),
    (b"P6", "a PNM picture"),
    (b"P7", "a PNM picture"),
    (b"%PDF", "a PDF document"),
    (b"%!PS", "a PostScript document"),
    (b"PK\x03\x04", "a ZIP archive"),
    (b"\x1F\x8B", "a file compressed by gzip"),
    (b"version https://git-lfs", "a pointer of Git LFS"),
];

/// The sentence about a file that is neither PNG nor JPEG nor BMP.
pub fn no_picture(bytes: &[u8]) -> String {
    match kind(bytes) {
        Some(kind) => format!("it is {kind}, and only PNG, JPEG and BMP pictures open"),
        None => "it is no PNG, JPEG or BMP picture".to_owned(),
    }
}

/// The sentence about a picture of a kind that the decoders do not know.
pub fn not_supported(kind: &str) -> String {
    format!("it is {kind}, which is not supported; save it as PNG with another program")
}

/// The kind of a file, by its first bytes.
fn kind(bytes: &[u8]) -> Option<&'static str> {
    if bytes.is_empty() {
        return Some("an empty file");
    }
    if bytes.iter().all(|byte| *byte == 0) {
        return Some("a file of zeros");
    }
    if let [_, _, _, _, b'f', b't', b'y', b'p', brand @ ..] = bytes {
        return Some(match brand.get(..4) {
            Some(b"avif" | b"avis") => "an AVIF picture",
            Some(b"heic" | b"heix" | b"hevc" | b"hevx" | b"mif1" | b"msf1") => "a HEIC picture",
            _ => "a film",
        });
    }
    if bytes.starts_with(b"RIFF") && bytes.get(8..12) == Some(b"WEBP") {
        return Some("a WebP picture");
    }
    let known = KINDS.iter().find(|(begin, _)| bytes.starts_with(begin));
    known.map(|(_, kind)| *kind).or_else(|| kind_of_text(bytes))
}

/// The kind of a text, by its first words.
fn kind_of_text(bytes: &[u8]) -> Option<&'static str> {
    let begin = bytes.get(..1024).unwrap_or(bytes);
    // The beginning may end within a character.
    let text = match std::str::from_utf8(begin) {
        Ok(text) => text,
        Err(error) if error.error_len().is_none() => {
            std::str::from_utf8(&begin[..error.valid_up_to()]).ok()?
        }
        Err(_) => return None,
    };
    let is_binary = |letter: char| letter.is_control() && !letter.is_whitespace();
    if text.is_empty() || text.contains(is_binary) {
        return None;
    }
    let text = text
        .trim_start_matches('\u{FEFF}')
        .trim_start()
        .to_ascii_lowercase();
    Some(if text.contains("<svg") {
        "an SVG drawing"
    } else if text.starts_with("<!doctype html") || text.contains("<html") {
        "a web page (HTML)"
    } else if text.starts_with('<') {
        "an XML text"
    } else {
        "a text"
    })
}

/// The kind of a BMP picture, if the decoder knows none of this kind.
pub fn unsupported_bmp(bytes: &[u8]) -> Option<String> {
    let number = |at: usize, length: usize| {
        let bytes = bytes.get(at..at + length)?.iter().rev();
        Some(bytes.fold(0_u32, |number, byte| number << 8 | u32::from(*byte)))
    };
    let header = number(14, 4)?;
    if header == 12 {
        return None;
    }
    let (bits, compression) = (number(28, 2)?, number(30, 4)?);
    // The headers of OS/2 2.x have 16 to 64 bytes; those of Windows have these.
    let is_of_windows = matches!(header, 40 | 52 | 56 | 108 | 124);
    let kind = match (is_of_windows, compression, bits) {
        (true, 4, _) => "a BMP picture that contains a JPEG",
        (true, 5, _) => "a BMP picture that contains a PNG",
        (true, 6, _) => "a BMP picture with alpha bitfields",
        (true, 11..=13, _) => "a BMP picture of CMYK colours",
        (true, 0, 64) => "a BMP picture with 64 bits per pixel",
        (false, 3, _) if (16..=64).contains(&header) => "a BMP picture in Huffman code, of OS/2",
        (false, 4, _) if (16..=64).contains(&header) => "a BMP picture in RLE24, of OS/2",
        (false, ..) if (16..=64).contains(&header) => "a BMP picture of OS/2 2.x",
        _ => return None,
    };
    Some(kind.to_owned())
}
