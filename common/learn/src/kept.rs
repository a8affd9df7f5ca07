//! `Kept`: what the program keeps from one run to the next, in a file that no commit contains.
//!
//! A line of the file is the name of an exercise and the hash of the student's file that a check
//! has found right; or, after a question mark, the id of a question, its box, and the days on which
//! it was asked for the first time and for the last time. Any other line is damaged. It counts for
//! nothing, but stays in the file as it is.

use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;

use common::{atomic_file, text};

use crate::files;
use crate::schedule::{Asked, BOXES};

const FILE: &str = ".learn";

/// The content of the file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Kept {
    /// Hashes of right files, by the names of the exercises.
    pub hashes: BTreeMap<String, u64>,
    /// The questions that have been asked, by their ids.
    pub asked: BTreeMap<String, Asked>,
    damaged: Vec<Vec<u8>>,
}

impl Kept {
    /// The content that the file has now; nothing if there is no file.
    pub fn read() -> Result<Self, String> {
        let path = files::shortest(FILE);
        match fs::read(&path) {
            Ok(bytes) => Ok(Self::from_bytes(&bytes)),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(Self::default()),
            Err(error) => Err(files::with_path(&path)(error)),
        }
    }

    /// Writes the file, which is complete whenever the program ends.
    pub fn write(&self) -> Result<(), String> {
        let path = files::shortest(FILE);
        atomic_file::write(&path, &self.to_bytes()).map_err(|error| error.to_string())
    }

    /// Says which lines of the file are damaged, if any are.
    pub fn warning(&self) -> Option<String> {
        let first = text::name(&String::from_utf8_lossy(self.damaged.first()?));
        Some(match self.damaged.len() {
            1 => {
                format!("{FILE} has a damaged line, \"{first}\": it stays, and counts for nothing")
            }
            count => format!(
                "{FILE} has {count} damaged lines, such as \"{first}\": they stay, and count for nothing"
            ),
        })
    }

    fn from_bytes(bytes: &[u8]) -> Self {
        let mut kept = Self::default();
        for line in bytes.split(|byte| *byte == b'\n') {
            let line = line.strip_suffix(b"\r").unwrap_or(line);
            if !line.is_empty() && kept.add(line).is_none() {
                kept.damaged.push(line.to_owned());
            }
        }
        kept
    }

    /// Adds what a line says; none if it is damaged.
    fn add(&mut self, line: &[u8]) -> Option<()> {
        let line = str::from_utf8(line).ok()?;
        match line.split(' ').collect::<Vec<_>>()[..] {
            ["?", id, number, first, last] => {
                let asked = Asked {
                    box_number: number.parse().ok().filter(|n| (1..=BOXES).contains(n))?,
                    first: first.parse().ok()?,
                    last: last.parse().ok()?,
                };
                self.asked.insert(id.to_owned(), asked);
            }
            [name, hash] => {
                let hash = u64::from_str_radix(hash, 16).ok()?;
                self.hashes.insert(name.to_owned(), hash);
            }
            _ => return None,
        }
        Some(())
    }

    fn to_bytes(&self) -> Vec<u8> {
        let mut lines = Vec::new();
        for (name, hash) in &self.hashes {
            lines.push(format!("{name} {hash:016x}\n").into_bytes());
        }
        for (id, asked) in &self.asked {
            let (number, first, last) = (asked.box_number, asked.first, asked.last);
            lines.push(format!("? {id} {number} {first} {last}\n").into_bytes());
        }
        for line in &self.damaged {
            lines.push([line, &b"\n"[..]].concat());
        }
        lines.concat()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_has_a_line_for_each_record() {
        let text = b"sphere 00000000000000ff\n? interval 2 20000 20003\n";
        let kept = Kept::from_bytes(text);
        assert_eq!(kept.hashes["sphere"], 255);
        let asked = Asked {
            box_number: 2,
            first: 20000,
            last: 20003,
        };
        assert_eq!(kept.asked["interval"], asked);
        assert_eq!(kept.warning(), None);
        assert_eq!(kept.to_bytes(), text);
    }

    #[test]
    fn a_damaged_line_is_named_and_stays() {
        let damaged: [&[u8]; 7] = [
            b"sphere",
            b"sphere 00x",
            b"? interval 0 1 1",
            b"? interval 6 1 1",
            b"? interval 1 1 -1",
            b"\xFF\xFE",
            b"<<<<<<< HEAD",
        ];
        for line in damaged {
            let text = [b"plane 0000000000000001\r\n", line, b"\r\n\n"].concat();
            let kept = Kept::from_bytes(&text);
            assert_eq!(kept.hashes.len() + kept.asked.len(), 1, "{line:?}");
            assert!(kept.warning().unwrap().contains("a damaged line"));
            let written = kept.to_bytes();
            assert_eq!(written, [b"plane 0000000000000001\n", line, b"\n"].concat());
            assert_eq!(Kept::from_bytes(&written), kept);
        }
        let two = Kept::from_bytes(b"a b c\nd e f");
        assert!(
            two.warning()
                .unwrap()
                .contains("2 damaged lines, such as \"a b c\"")
        );
    }
}
