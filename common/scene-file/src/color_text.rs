//! `color_text`: the three bytes of a colour in a text, such as `#ff8000` or `orange`.

use common::text;

use crate::error::nearest;

/// The names and the bytes of the colours of CSS (CSS Color Module Level 4, section 6.1).
const NAMES: &str = include_str!("css_colors.txt");

/// The names of the colours of CSS, in the order of the alphabet.
pub fn names() -> impl Iterator<Item = &'static str> {
    rows().map(|(name, _)| name)
}

/// The names, and the bytes in hexadecimal digits.
fn rows() -> impl Iterator<Item = (&'static str, &'static str)> {
    NAMES.lines().filter_map(|line| line.split_once(' '))
}

/// The red, green and blue bytes of a colour: six or three hexadecimal digits behind a #, or a
/// name in small or capital letters. The error is a clause.
pub fn bytes(color: &str) -> Result<[u8; 3], String> {
    if let Some(digits) = color.strip_prefix('#') {
        return of_digits(digits).ok_or_else(|| {
            let color = text::name(color);
            format!(
                "\"{color}\" is no color: behind # stand three or six hexadecimal \
                 digits, such as #ff8000"
            )
        });
    }
    let name = color.to_ascii_lowercase();
    let found = rows().find(|(known, _)| *known == name);
    let found = found.and_then(|(_, digits)| of_digits(digits));
    found.ok_or_else(|| {
        if of_digits(color).is_some() {
            return format!("\"{color}\" lacks a # before its digits: \"#{color}\"");
        }
        let known: Vec<_> = names().collect();
        let nearest = nearest(&known, &name);
        let hint = if nearest.is_empty() {
            "; a color is a name of CSS such as \"orange\", or digits such as \"#ff8000\""
        } else {
            ""
        };
        format!("there is no color \"{}\"{nearest}{hint}", text::name(color))
    })
}

/// The bytes of `rrggbb`, or of `rgb`, each of whose digits stands twice.
fn of_digits(digits: &str) -> Option<[u8; 3]> {
    if !digits.bytes().all(|digit| digit.is_ascii_hexdigit()) {
        return None;
    }
    let number = u32::from_str_radix(digits, 16).ok()?;
    let [_, red, green, blue] = number.to_be_bytes();
    match digits.len() {
        6 => Some([red, green, blue]),
        3 => Some([green % 16, blue / 16, blue % 16].map(|digit| 17 * digit)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_and_names_are_read() {
        for (color, expected) in [
            ("#c0ffee", [0xc0, 0xff, 0xee]),
            ("#C0FFEE", [0xc0, 0xff, 0xee]),
            ("#1f8", [0x11, 0xff, 0x88]),
            ("orange", [255, 165, 0]),
            ("RebeccaPurple", [102, 51, 153]),
            ("grey", [128; 3]),
        ] {
            assert_eq!(bytes(color), Ok(expected), "{color}");
        }
        assert!(bytes("#+f8000").is_err());
        for line in NAMES.lines() {
            assert!(
                names().any(|name| line.starts_with(name) && bytes(name).is_ok()),
                "{line}"
            );
        }
    }
}
