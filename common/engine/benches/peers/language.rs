//! Scenes as text: the languages of POV-Ray 3.7 and Tachyon 0.99 are files with a phrase for
//! each kind of item. `[0]` stands for its first vector, `[0x]` for a number of that.

use std::io::{self, ErrorKind, Write};

use crate::scene::{Item, Kind};

/// The phrases of a language, and what stands between the numbers of a vector.
#[derive(Clone, Copy)]
pub struct Language {
    phrases: &'static str,
    separator: &'static str,
}

pub const POV_RAY: Language = Language {
    phrases: include_str!("povray.txt"),
    separator: ", ",
};

pub const TACHYON: Language = Language {
    phrases: include_str!("tachyon.txt"),
    separator: " ",
};

impl Language {
    /// Writes a scene. The error is of the kind `Unsupported` if a phrase is missing.
    pub fn write(self, out: &mut impl Write, items: impl Iterator<Item = Item>) -> io::Result<()> {
        let mut transforms = String::new();
        for item in items {
            let text = self.text(&item).ok_or(ErrorKind::Unsupported)?;
            if matches!(item.kind, Kind::Transform) {
                transforms += &text;
            } else {
                writeln!(out, "{}", text.replace("[transforms]", &transforms))?;
                transforms.clear();
            }
        }
        Ok(())
    }

    /// The text of an item; none if there is no phrase.
    fn text(self, item: &Item) -> Option<String> {
        let name = format!("{:?}:", item.kind);
        let phrase = self
            .phrases
            .lines()
            .find_map(|line| line.strip_prefix(&name))?;
        let mut text = phrase.trim().replace("[material]", &item.color.to_string());
        for (i, vector) in item.vectors.iter().enumerate() {
            let numbers = vector.to_array().map(|number| number.to_string());
            text = text.replace(&format!("[{i}]"), &numbers.join(self.separator));
            for (axis, number) in ["x", "y", "z"].into_iter().zip(numbers) {
                text = text.replace(&format!("[{i}{axis}]"), &number);
            }
        }
        Some(text)
    }
}
