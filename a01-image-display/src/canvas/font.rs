//! The letters of diagrams: 8x8 dots each.

use font8x8::legacy::{BASIC_LEGACY, LATIN_LEGACY};

/// Column and row of each dot of a text in one row, from its upper left corner.
///
/// The font has the characters of ASCII and Latin-1. Any other character becomes a question
/// mark.
pub fn dots(text: &str) -> impl Iterator<Item = (u32, u32)> {
    let letters = (0..).step_by(8).zip(text.chars());
    letters.flat_map(|(left, letter)| {
        let rows = (0..).zip(glyph(letter));
        rows.flat_map(move |(row, bits)| {
            let columns = (0..8).filter(move |column| bits >> column & 1 == 1);
            columns.map(move |column| (left + column, row))
        })
    })
}

/// Eight rows from the top; the lowest bit is the leftmost dot.
fn glyph(character: char) -> [u8; 8] {
    let code = character as usize;
    match character {
        ' '..='~' => BASIC_LEGACY[code],
        '\u{a0}'..='\u{ff}' => LATIN_LEGACY[code - 0xa0],
        _ => glyph('?'),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_follow_one_another_dot_by_dot() {
        let mut rows = [[' '; 16]; 8];
        for (column, row) in dots("lL") {
            rows[row as usize][column as usize] = '#';
        }
        let lines = rows.map(|row| row.into_iter().collect::<String>());
        assert_eq!(
            lines.map(|line| line.trim_end().to_owned()),
            [
                " ###    ####",
                "  ##     ##",
                "  ##     ##",
                "  ##     ##",
                "  ##     ##   #",
                "  ##     ##  ##",
                " ####   #######",
                "",
            ]
        );
    }

    #[test]
    fn characters_differ_and_unknown_ones_are_question_marks() {
        let mut shapes = std::collections::HashSet::from([glyph('?'), glyph(' ')]);
        for character in "AZaz09+-*/=<>|äöüßñ±×÷°²½".chars() {
            assert!(shapes.insert(glyph(character)), "{character}");
        }
        for character in "\u{7}\n\u{85}α→中𝛼".chars() {
            assert_eq!(glyph(character), glyph('?'), "{character:?}");
        }
    }
}
