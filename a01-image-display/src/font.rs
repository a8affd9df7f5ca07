//! The letters of diagrams: 8x8 dots each.

use font8x8::legacy::{BASIC_LEGACY, GREEK_LEGACY, LATIN_LEGACY, MISC_LEGACY};

/// Column and row of each dot of a text in one row, from its upper left corner.
///
/// The font has the characters of ASCII, Latin-1 and Greek, and a few signs like ≤ and ≥.
/// Any other character becomes a question mark.
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
        // Between rho and sigma one code point is not assigned.
        '\u{390}'..='\u{3a1}' | '\u{3a3}'..='\u{3c9}' => GREEK_LEGACY[code - 0x390],
        '≤' => MISC_LEGACY[5],
        '≥' => MISC_LEGACY[6],
        // Minus and the dot operator look like characters of Latin-1.
        '−' => glyph('-'),
        '⋅' => glyph('·'),
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
        for character in "AZaz09+-*/=<>|äöüßñ±×÷°²½Ωαγδθλμπρστφω≤≥".chars()
        {
            assert!(shapes.insert(glyph(character)), "{character}");
        }
        for character in "\u{7}\n\u{85}\u{3a2}→中𝛼".chars() {
            assert_eq!(glyph(character), glyph('?'), "{character:?}");
        }
    }
}
