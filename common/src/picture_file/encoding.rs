//! Encodes PNG band by band, so that only one band of a picture need be in memory.

use std::cell::Cell;
use std::io::{self, Write};

use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};

use crate::{Error, Size};

/// Writes bands of rows, from the top, as a PNG file. `explain` converts errors of
/// the file. The first error of a band or of the file is returned.
///
/// # Panics
///
/// If the bands together do not hold three bytes for every pixel of `size`.
pub fn encode<B: AsRef<[u8]>>(
    file: &mut impl Write,
    size: Size,
    bands: impl IntoIterator<Item = Result<B, Error>>,
    explain: impl Fn(io::Error) -> Error,
) -> Result<(), Error> {
    let failure = Cell::new(None);
    let check = || failure.take().map_or(Ok(()), |error| Err(explain(error)));
    let refuse = |error: EncodingError| explain(error.into());
    let output = Output {
        file,
        failure: &failure,
    };
    let mut encoder = Encoder::new(output, size.width(), size.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Fast);
    let mut writer = encoder.write_header().map_err(refuse)?;
    let mut pixels = writer.stream_writer().map_err(refuse)?;
    let mut missing = 3 * size.pixels();
    for band in bands {
        let band = band?;
        let rgb = band.as_ref();
        assert!(rgb.len() <= missing, "three bytes a pixel");
        missing -= rgb.len();
        pixels.write_all(rgb).map_err(&explain)?;
        check()?;
    }
    assert_eq!(missing, 0, "three bytes a pixel");
    pixels.finish().map_err(refuse)?;
    writer.finish().map_err(refuse)?;
    check()
}

/// Passes bytes on to a file, and hides its errors from the encoder, which panics at
/// some errors and drops errors of the last bytes. The latest error is kept.
struct Output<'a, W> {
    file: &'a mut W,
    failure: &'a Cell<Option<io::Error>>,
}

impl<W: Write> Write for Output<'_, W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if let Err(error) = self.file.write_all(bytes) {
            self.failure.set(Some(error));
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A disk with room for this many bytes.
    struct Disk(usize);

    impl Write for Disk {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let written = bytes.len().min(self.0);
            self.0 -= written;
            if written == 0 {
                return Err(io::ErrorKind::StorageFull.into());
            }
            Ok(written)
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    fn encode_to(file: &mut impl Write, side: u32, rgb: &[u8]) -> Result<(), Error> {
        let size = Size::new(side, side).unwrap();
        let bands = rgb.chunks(side as usize * 3).map(Ok);
        encode(file, size, bands, |error| {
            Error::Usage(error.kind().to_string())
        })
    }

    #[test]
    fn a_disk_that_is_full_is_an_error_at_every_byte() {
        // Bytes without a pattern, so that there is more than one chunk.
        let noise = |n: u32| (n.wrapping_mul(2_654_435_761) >> 24) as u8;
        for (side, step) in [(9, 1), (120, 997)] {
            let rgb: Vec<u8> = (0..3 * side * side).map(noise).collect();
            let mut whole = Vec::new();
            encode_to(&mut whole, side, &rgb).unwrap();
            encode_to(&mut Disk(whole.len()), side, &rgb).unwrap();
            let last = whole.len() - 40..whole.len();
            for room in (0..whole.len()).step_by(step).chain(last) {
                let error = encode_to(&mut Disk(room), side, &rgb).unwrap_err();
                let expected = io::ErrorKind::StorageFull.to_string();
                assert_eq!(error.to_string(), expected, "{room} of {}", whole.len());
            }
        }
    }

    #[test]
    #[should_panic(expected = "three bytes a pixel")]
    fn too_few_bytes_are_a_mistake() {
        let _ = encode_to(&mut Vec::new(), 2, &[0; 11]);
    }

    #[test]
    #[should_panic(expected = "three bytes a pixel")]
    fn too_many_bytes_are_a_mistake() {
        let _ = encode_to(&mut Vec::new(), 2, &[0; 13]);
    }
}
