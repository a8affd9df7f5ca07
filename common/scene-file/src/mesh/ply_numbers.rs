//! `Numbers`: the numbers of a PLY file behind its header.

use common::text;

use super::ply_header::{Encoding, Type};

/// The numbers that are not yet read.
#[derive(Debug)]
pub struct Numbers<'a> {
    /// How they are written.
    pub encoding: Encoding,
    /// The bytes behind the last number.
    pub rest: &'a [u8],
}

/// Why there is no number.
#[derive(Debug)]
pub enum NoNumber {
    /// The file is at its end.
    End,
    /// This word is none.
    Word(String),
}

impl Numbers<'_> {
    /// The next number of a type.
    pub fn next(&mut self, kind: Type) -> Result<f64, NoNumber> {
        if self.encoding == Encoding::Ascii {
            return self.word();
        }
        Ok(match kind {
            Type::Int8 => i8::from_le_bytes(self.bytes()?).into(),
            Type::Uint8 => u8::from_le_bytes(self.bytes()?).into(),
            Type::Int16 => i16::from_le_bytes(self.bytes()?).into(),
            Type::Uint16 => u16::from_le_bytes(self.bytes()?).into(),
            Type::Int32 => i32::from_le_bytes(self.bytes()?).into(),
            Type::Uint32 => u32::from_le_bytes(self.bytes()?).into(),
            Type::Float32 => f32::from_le_bytes(self.bytes()?).into(),
            Type::Float64 => f64::from_le_bytes(self.bytes()?),
        })
    }

    /// The next word as a number.
    fn word(&mut self) -> Result<f64, NoNumber> {
        let text = self.rest.trim_ascii_start();
        let end = text.iter().position(u8::is_ascii_whitespace);
        let (word, rest) = text.split_at(end.unwrap_or(text.len()));
        self.rest = rest;
        if word.is_empty() {
            return Err(NoNumber::End);
        }
        let word = String::from_utf8_lossy(word);
        number(&word).ok_or_else(|| NoNumber::Word(text::name(&word)))
    }

    /// The bytes of the next number, the least significant one first.
    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], NoNumber> {
        let (bytes, rest) = self.rest.split_first_chunk().ok_or(NoNumber::End)?;
        self.rest = rest;
        let mut bytes: [u8; N] = *bytes;
        if self.encoding == Encoding::BigEndian {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

/// The number of a word. Programs for Windows write NaN as `-nan(ind)` or `1.#QNAN`, and infinity, which is as good
/// as NaN, as `1.#INF`.
pub fn number(word: &str) -> Option<f64> {
    let is_of_windows = word.contains("nan(") || word.contains(".#");
    word.parse().ok().or(is_of_windows.then_some(f64::NAN))
}
