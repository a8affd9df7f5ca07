//! `text`: numbers, names and paths in messages, so that no message is long without need, and
//! none moves the cursor of a terminal; and the name that is nearest to a misspelt one.

use std::fmt::Write;
use std::path::Path;

/// Most letters of a name from a file in a message, and of a path.
const MAX_NAME: usize = 80;
const MAX_PATH: usize = 400;
/// Most letters of a line of a message.
const MAX_LINE: usize = 2000;

/// A number in the shortest form that reads as the same number: at most 17 digits, with an
/// exponent if it is huge or tiny.
#[must_use]
pub fn number(number: f64) -> String {
    // Rust's form for programmers has an exponent from 1e16 on and below 1e-4.
    let text = format!("{number:?}");
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

/// A number with at most this many significant digits, with an exponent if it is huge or tiny.
#[must_use]
pub fn rounded(number: f64, digits: usize) -> String {
    let rounded = format!("{number:.*e}", digits.max(1) - 1);
    match rounded.parse().unwrap_or(number) {
        x if x != 0.0 && !(1e-3..1e6).contains(&f64::abs(x)) && x.is_finite() => format!("{x:e}"),
        // Not "-0".
        x => (x + 0.0).to_string(),
    }
}

/// Numbers with commas between them, without brackets.
#[must_use]
pub fn numbers(numbers: &[f64]) -> String {
    let numbers: Vec<_> = numbers.iter().map(|n| number(*n)).collect();
    numbers.join(", ")
}

/// The text on one line, in which characters that nobody sees, or that a terminal would obey, are
/// seen: a newline as `\n`.
#[must_use]
pub fn visible(text: &str) -> String {
    escaped(text, |_| false)
}

/// Like [`visible`], with the newlines of the text.
#[must_use]
pub fn visible_lines(text: &str) -> String {
    escaped(text, |letter| letter == '\n')
}

/// A message for a terminal: its lines are visible, and shortened in their middle.
#[must_use]
pub fn message(text: &str) -> String {
    let lines: Vec<_> = text
        .split('\n')
        .map(|line| visible(&shortened(line, MAX_LINE)))
        .collect();
    lines.join("\n")
}

/// The text of a file's bytes in UTF-8, with or without a byte order mark.
///
/// # Errors
///
/// Fails if the bytes are no such text; the error is a clause that says so.
pub fn from_file(bytes: Vec<u8>) -> Result<String, String> {
    if let [0xFF, 0xFE, ..]
    | [0xFE, 0xFF, ..]
    | [0, 1..=255, 0, 1..=255, ..]
    | [1..=255, 0, 1..=255, 0, ..] = *bytes
    {
        return Err("it is a text in UTF-16; save it in UTF-8".to_owned());
    }
    let error = match String::from_utf8(bytes) {
        Ok(text) => return Ok(text),
        Err(error) => error,
    };
    let bytes = error.as_bytes();
    if bytes.contains(&0) {
        return Err("it is no text".to_owned());
    }
    let before = &bytes[..error.utf8_error().valid_up_to()];
    let line = before.split(|byte| *byte == b'\n').count();
    Err(format!(
        "line {line} has a letter that is not in UTF-8; save the file in UTF-8"
    ))
}

/// A name from a file or the command line: visible, and shortened in its middle.
#[must_use]
pub fn name(text: &str) -> String {
    visible(&shortened(text, MAX_NAME))
}

/// A path: visible, and shortened in its middle.
#[must_use]
pub fn path(path: &Path) -> String {
    visible(&shortened(&path.to_string_lossy(), MAX_PATH))
}

/// The known name that is most like a misspelt one, if one is like it. Capital letters and `_` do
/// not count.
#[must_use]
pub fn nearest<'a>(known: &[&'a str], name: &str) -> Option<&'a str> {
    let name = plain(name);
    let mut nearest = None;
    let mut best = 0.5;
    for known in known {
        let likeness = strsim::normalized_damerau_levenshtein(&plain(known), &name);
        if likeness >= best {
            (nearest, best) = (Some(*known), likeness);
        }
    }
    nearest
}

/// A name without what does not count in a comparison: capital letters, `_` and outer spaces.
#[must_use]
pub fn plain(name: &str) -> String {
    name.trim().to_lowercase().replace('_', "")
}

fn escaped(text: &str, is_kept: impl Fn(char) -> bool) -> String {
    let mut visible = String::new();
    for letter in text.chars() {
        let _ = if is_unseen(letter) && !is_kept(letter) {
            write!(visible, "{}", letter.escape_default())
        } else {
            write!(visible, "{letter}")
        };
    }
    visible
}

/// Whether nobody sees a character, or sees it as a space: it moves the cursor, changes the order of
/// letters, or has no width.
#[must_use]
pub fn is_unseen(letter: char) -> bool {
    letter.is_control()
        || matches!(
            letter,
            '\u{A0}' | '\u{AD}' | '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202F}'
                | '\u{2060}'..='\u{206F}' | '\u{FEFF}'
        )
}

/// A text of at most this many letters, with … instead of its middle.
fn shortened(text: &str, most: usize) -> String {
    let count = text.chars().count();
    if count <= most {
        return text.to_owned();
    }
    let begin: String = text.chars().take(most / 2).collect();
    let end: String = text.chars().skip(count + 1 - most / 2).collect();
    format!("{begin}…{end}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounded_numbers_take_few_characters() {
        for (value, text) in [
            (0.0, "0"),
            (-1e-320_f64 * 1e-10, "0"),
            (0.123_46, "0.123"),
            (9.96e-4, "9.96e-4"),
            (999_999.9, "1e6"),
            (-123_456.0, "-123000"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(rounded(value, 3), text);
        }
    }

    #[test]
    fn numbers_have_at_most_17_digits() {
        for (value, text) in [
            (0.1, "0.1"),
            (-0.0, "-0"),
            (2.0, "2"),
            (1e15, "1000000000000000"),
            (1e300, "1e300"),
            (5e-310, "5e-310"),
            (-1e150, "-1e150"),
            (f64::NAN, "NaN"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(number(value), text);
        }
        let mut value = 1.234e-320;
        while value < 1e300 {
            let text = number(value);
            let digits = text.split('e').next().unwrap_or_default();
            let digits = digits.chars().filter(char::is_ascii_digit);
            let digits = digits.skip_while(|digit| *digit == '0').count();
            assert!(digits <= 17, "{text}");
            assert_eq!(text.parse(), Ok(value));
            value *= 1234.567;
        }
        assert_eq!(numbers(&[1.0, 1e99]), "1, 1e99");
    }

    #[test]
    fn files_in_other_encodings_are_named() {
        for (bytes, said) in [
            (&b"\xFF\xFEa\0"[..], "UTF-16"),
            (b"a\0b\0", "UTF-16"),
            (b"\0a\0b", "UTF-16"),
            (b"\x89PNG\r\n\x1A\n\0\0\0\rIHDR", "it is no text"),
            (b"a\nb\xE4", "line 2 has a letter"),
        ] {
            let error = from_file(bytes.to_vec()).unwrap_err();
            assert!(error.contains(said), "{error}");
        }
        assert_eq!(from_file(b"a".to_vec()).unwrap(), "a");
    }

    #[test]
    fn messages_obey_no_character_of_a_name() {
        assert_eq!(
            visible("a\u{8}b\nc\u{1B}[2Jü日\u{202E}"),
            r"a\u{8}b\nc\u{1b}[2Jü日\u{202e}"
        );
        assert_eq!(visible_lines("a\n\tb"), "a\n\\tb");
        assert_eq!(name(&"x".repeat(5000)).chars().count(), MAX_NAME);
        assert_eq!(name("short"), "short");
        let lines = message(&format!("{}\n{}\n", "z".repeat(50_000), "a\u{7}"));
        assert_eq!(lines.len(), MAX_LINE + "…".len() - 1 + "\na\\u{7}\n".len());
        let long = Path::new("folder/")
            .join("y".repeat(5000))
            .join("scene.toml");
        let shown = path(&long);
        assert!(shown.starts_with("folder/y") && shown.ends_with("y/scene.toml"));
        assert_eq!(shown.chars().count(), MAX_PATH);
    }
}
