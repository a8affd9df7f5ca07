//! Faults of PNG files that the decoder passes over without a word.

use std::io::Cursor;

use png::{ColorType, Decoder, DecodingError};

/// The fault of a file that the decoder opens, as a clause.
pub fn fault(bytes: &[u8]) -> Option<&'static str> {
    if has_more_rows(bytes) {
        Some("it has more rows of pixels than its header says")
    } else if is_beyond_palette(bytes).unwrap_or(false) {
        Some("it has pixels of colours that its palette lacks")
    } else {
        None
    }
}

/// Whether the data go on with another row. The rows of an interlaced picture lie at other places if it is
/// higher, so that most of these pass.
fn has_more_rows(bytes: &[u8]) -> bool {
    let mut higher = bytes.to_vec();
    // Behind the signature, the length and the name of the first chunk, and the width.
    if let Some(height) = higher.get_mut(20..).and_then(<[u8]>::first_chunk_mut) {
        *height = (u32::from_be_bytes(*height) + 1).to_be_bytes();
    }
    let mut decoder = Decoder::new(Cursor::new(higher));
    decoder.ignore_checksums(true);
    let Ok(mut reader) = decoder.read_info() else {
        return false;
    };
    loop {
        match reader.next_row() {
            Ok(Some(_)) => {}
            Ok(None) => return true,
            Err(_) => return false,
        }
    }
}

fn is_beyond_palette(bytes: &[u8]) -> Result<bool, DecodingError> {
    let mut reader = Decoder::new(Cursor::new(bytes)).read_info()?;
    let info = reader.info();
    let colors = match &info.palette {
        Some(palette) if info.color_type == ColorType::Indexed => palette.len() / 3,
        _ => return Ok(false),
    };
    let (width, bits) = (info.width as usize, info.bit_depth as usize);
    let length = (width * bits).div_ceil(8);
    let mut rows = vec![0; length * info.height as usize];
    reader.next_frame(&mut rows)?;
    // The pixels of a byte, of 1, 2, 4 or 8 bits, begin at its highest bit.
    let index = |row: &[u8], x: usize| {
        let behind = 8 - bits - (x * bits) % 8;
        usize::from(row[x * bits / 8] >> behind) % (1 << bits)
    };
    let mut rows = rows.chunks(length);
    Ok(rows.any(|row| (0..width).any(|x| index(row, x) >= colors)))
}
