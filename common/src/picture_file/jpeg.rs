//! Judges JPEG files: whether their kind is supported, and whether they are whole. The decoder
//! does not say so: it paints what is missing grey.
//!
//! Markers and segments are those of ITU-T T.81, annex B.

use std::borrow::Cow;

use super::ENDS_TOO_EARLY;

/// Marks the end of the picture.
const END_OF_IMAGE: [u8; 2] = [0xFF, 0xD9];

/// Bytes without a marker, the first bit of which is 1 where the decoder would add a 0.
const OTHER_BITS: [u8; 7] = [0xB6, 0x6D, 0xDB, 0x59, 0x35, 0x9A, 0xC3];

/// The parts of a JPEG file that tell whether it is whole.
#[derive(Debug, Default)]
pub struct Jpeg<'a> {
    /// The file up to its end mark, or to its last byte that is not 0.
    data: &'a [u8],
    /// Whether the end mark is there.
    pub has_end: bool,
    /// The marker of the frame and its parameters: bits per channel, height, width, components.
    frame: Option<(u8, &'a [u8])>,
    /// The parameters of the scans: components, and the part of their coefficients.
    scans: Vec<&'a [u8]>,
    /// Whether the data are divided into parts that can be decoded alone.
    has_restarts: bool,
}

impl<'a> Jpeg<'a> {
    /// Finds the parts of a file. It is an error if the file ends before the first pixel, or if
    /// its kind is not supported.
    pub fn read(bytes: &'a [u8]) -> Result<Self, String> {
        let mut jpeg = Self {
            data: without_zeros(bytes),
            ..Self::default()
        };
        let mut at = 2;
        while let Some(marker_at) = find_marker(bytes, at) {
            let marker = bytes[marker_at];
            at = marker_at + 1;
            if marker == END_OF_IMAGE[1] {
                jpeg.has_end = true;
                jpeg.data = before_fill_bytes(&bytes[..marker_at]);
                break;
            }
            // Markers without a segment: temporary, restart and start of image.
            if matches!(marker, 0x01 | 0xD0..=0xD8) {
                continue;
            }
            let Some(parameters) = segment(bytes, at) else {
                return Err(ENDS_TOO_EARLY.to_owned());
            };
            at += 2 + parameters.len();
            match marker {
                0xC4 | 0xC8 | 0xCC => (),
                0xC0..=0xCF | 0xF7 => jpeg.frame = Some((marker, parameters)),
                0xDA => jpeg.scans.push(parameters),
                0xDD => jpeg.has_restarts = true,
                _ => (),
            }
        }
        if jpeg.scans.is_empty() && !jpeg.has_end {
            return Err(ENDS_TOO_EARLY.to_owned());
        }
        if let Some(kind) = jpeg.unsupported_kind() {
            return Err(super::kind::not_supported(&kind));
        }
        Ok(jpeg)
    }

    /// The kind of the picture, if the decoder knows no pictures of this kind.
    fn unsupported_kind(&self) -> Option<String> {
        let (marker, parameters) = self.frame?;
        let kind = match marker {
            0xC3 => "a lossless JPEG picture",
            0xC5..=0xC7 | 0xCD..=0xCF => "a hierarchical JPEG picture",
            0xC9 | 0xCA => "a JPEG picture with arithmetic coding",
            0xCB => "a lossless JPEG picture with arithmetic coding",
            0xF7 => "a JPEG-LS picture",
            _ => match parameters {
                [12, ..] => "a JPEG picture with 12 bits per channel",
                [8, 0, 0, ..] => "a JPEG picture that has its height behind the pixels",
                _ => return None,
            },
        };
        Some(kind.to_owned())
    }

    /// The file with an end mark.
    pub fn with_end(&self, file: &'a [u8]) -> Cow<'a, [u8]> {
        if self.has_end {
            Cow::Borrowed(file)
        } else {
            Cow::Owned([self.data, &END_OF_IMAGE].concat())
        }
    }

    /// The file with other bits behind its data than the zeros that the decoder adds to data that
    /// end too early. If its pixels are those of the file, no bit is missing.
    pub fn continued(&self) -> Vec<u8> {
        let mut continued = self.data.to_vec();
        let bits = OTHER_BITS.repeat(64);
        continued.extend(&bits);
        if self.has_restarts {
            // The bits before a restart are skipped if it is due.
            continued.extend([0xFF, 0xD0]);
            continued.extend(&bits);
        }
        continued.extend(END_OF_IMAGE);
        continued
    }

    /// Whether there is an end mark, or the scans have each coefficient of each component to its
    /// last bit, so that no further scan is missing.
    pub fn has_all_scans(&self) -> bool {
        let Some((marker, &[_, _, _, _, _, _, ref components @ ..])) = self.frame else {
            return self.has_end;
        };
        let is_progressive = marker == 0xC2;
        let has_all_bits = |component: u8| {
            let mut lowest_bits = [u8::MAX; 64];
            for scan in &self.scans {
                let [count, ref of_scan @ ..] = **scan else {
                    continue;
                };
                let (names, rest) = of_scan.split_at(of_scan.len().min(2 * usize::from(count)));
                if names.chunks(2).any(|name| name[0] == component) {
                    let [first, last, bits] = match *rest {
                        [first, last, bits] if is_progressive => [first, last.min(63), bits & 15],
                        _ => [0, 63, 0],
                    };
                    let part = lowest_bits.get_mut(first.into()..=last.into());
                    part.into_iter().flatten().for_each(|bit| *bit = bits);
                }
            }
            lowest_bits == [0; 64]
        };
        self.has_end || components.chunks(3).all(|named| has_all_bits(named[0]))
    }
}

/// The place of the next marker from a place on: behind 0xFF is neither 0, which belongs to the
/// data, nor a fill byte, 0xFF.
fn find_marker(bytes: &[u8], from: usize) -> Option<usize> {
    let pairs = bytes.get(from..)?.windows(2);
    let found = pairs
        .enumerate()
        .find(|(_, pair)| pair[0] == 0xFF && !matches!(pair[1], 0 | 0xFF));
    found.map(|(i, _)| from + i + 1)
}

/// The parameters of a segment; none if the file ends before they do.
fn segment(bytes: &[u8], at: usize) -> Option<&[u8]> {
    let length = u16::from_be_bytes(bytes.get(at..at + 2)?.try_into().ok()?);
    bytes.get(at + 2..at + usize::from(length.max(2)))
}

/// The bytes without zeros at their end, with which some programs fill the missing part of a
/// file. A few may belong to the data, and so does a zero behind 0xFF.
fn without_zeros(bytes: &[u8]) -> &[u8] {
    let zeros = bytes.iter().rev().take_while(|byte| **byte == 0).count();
    let data = &bytes[..bytes.len() - zeros];
    match (zeros, data.ends_with(&[0xFF])) {
        (0, _) => before_fill_bytes(bytes),
        (1..8, _) => bytes,
        (_, true) => &bytes[..=data.len()],
        (_, false) => data,
    }
}

/// The bytes before a marker, whose first byte is repeated in some files.
fn before_fill_bytes(bytes: &[u8]) -> &[u8] {
    let fill = bytes.iter().rev().take_while(|byte| **byte == 0xFF).count();
    &bytes[..bytes.len() - fill]
}
