//! Scenes as text: a language is a file with a phrase for each kind of item. `[0]` stands for
//! the first vector of an item, `[0x]` for a number of that.

use std::io::{self, Write};

use crate::support::scene::{Item, Kind};

pub const POV_RAY: &str = include_str!("povray.txt");
pub const TACHYON: &str = include_str!("tachyon.txt");

/// Writes a scene. It is an error if the language lacks a phrase.
pub fn write(
    out: &mut impl Write,
    language: &str,
    items: impl Iterator<Item = Item>,
) -> io::Result<()> {
    let mut transforms = String::new();
    for item in items {
        let missing = || io::Error::other(format!("no word for a {:?}", item.kind));
        let text = text(language, &item).ok_or_else(missing)?;
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
fn text(language: &str, item: &Item) -> Option<String> {
    let of = |name: &str| language.lines().find_map(|line| line.strip_prefix(name));
    let phrase = of(&format!("{:?}:", item.kind))?;
    let mut text = phrase.replace("[material]", &item.color.to_string());
    for (i, numbers) in item.vectors.iter().enumerate() {
        let mut vector = of("Vector: ")?.to_owned();
        for (axis, number) in ["x", "y", "z"].into_iter().zip(numbers.to_array()) {
            vector = vector.replace(axis, &number.to_string());
            text = text.replace(&format!("[{i}{axis}]"), &number.to_string());
        }
        text = text.replace(&format!("[{i}]"), &vector);
    }
    Some(text)
}
