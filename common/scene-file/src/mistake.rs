//! `mistake`: a mistake against TOML, in the parser's words, with the line in which it is.

use common::text;
use toml::de::Error as ParserError;

use crate::Error;
use crate::uses::MAX_LEVELS;

/// What is right where a backslash stands in double quotation marks.
pub const BACKSLASH: &str = "in double quotation marks \\ begins a special character; write / \
    between folders, or single quotation marks, such as 'models\\bunny.obj'";

/// Characters that text processors write, and those of TOML.
const ALIKE: [(&str, &str); 3] = [("−–—", "-"), ("“”„", "\""), ("‘’", "'")];

/// The error of a text that the parser refuses.
pub fn mistake(text: &str, error: &ParserError) -> Error {
    let span = error.span().unwrap_or_default();
    let at = text.floor_char_boundary(span.start);
    let line_start = text[..at].rfind('\n').map_or(0, |newline| newline + 1);
    let line = text[line_start..].lines().next().unwrap_or_default();
    for (offset, letter) in line.char_indices() {
        if text::is_unseen(letter) && letter != '\t' {
            let unseen = letter.escape_unicode();
            let instead = match letter {
                '\r' => "; save the file with line ends LF or CRLF",
                '\0' => "; save the file as text, in UTF-8",
                _ => "",
            };
            let text = format!("here is the character {unseen}, which nobody sees{instead}");
            return Error::new(line_start + offset, text);
        }
    }
    for (wrong, right) in ALIKE {
        if let Some(letter) = text[at..].chars().next()
            && wrong.contains(letter)
        {
            return Error::new(
                at,
                format!("here is the character {letter} instead of {right}"),
            );
        }
    }
    if error.message().contains("recur") {
        let limit = format!("more than {MAX_LEVELS} tables or lists stand inside each other");
        return Error::new(at, limit);
    }
    let said = error.message().replace('\n', ", ");
    // The parser guesses these words, of which a scene file takes none.
    let is_guess = said.ends_with("expected `nan`") || said.ends_with("expected `inf`");
    let message = if is_guess { "invalid value" } else { &said };
    let said =
        hint(message, line, at - line_start).map_or_else(|| text::visible(message), str::to_owned);
    Error::new(at, format!("{said}: {}", text::name(line.trim())))
}

/// What is right instead of what was probably meant.
fn hint(message: &str, line: &str, at: usize) -> Option<&'static str> {
    // The value in which the mistake is. Of a list over several lines, a line has no key.
    let before = line.get(..at).unwrap_or(line).rfind('=');
    let value = before.map_or(line, |equals| &line[equals + 1..]).trim();
    let begins_with = |letters: &str| value.starts_with(|first| letters.contains(first));
    let has = |marks: &[&str]| marks.iter().any(|mark| line.contains(mark));
    if message.starts_with("duplicate key") {
        Some(
            "it is there already: a key stands once in its table, and a table of which there may be several has two \
             pairs of brackets, such as [[sphere]]",
        )
    } else if message.contains("between array elements") {
        Some("the list before this place has no ] at its end, or lacks a comma")
    } else if line.contains('\\') {
        Some(BACKSLASH)
    } else if has(&["//", "/*", "--", ";"]) {
        Some("a comment begins with #, and nothing else stands behind a value")
    } else if line.starts_with('[') && (message.contains("table") || message.contains("key")) {
        Some(
            "a header stands alone in its line, such as [camera] or [[sphere]], and a name with other \
             characters than a to z, 0 to 9, - and _ in quotation marks, such as [material.\"Käse\"]",
        )
    } else if message.starts_with("key with no value") {
        Some("a key has = and a value behind it, such as radius = 0.8")
    } else if value.is_empty() || value.starts_with('#') {
        Some(
            "behind = a value is missing; one with # stands in quotation marks, such as \"#ff8000\"",
        )
    } else if begins_with("\"'") {
        Some(
            "a text ends with the quotation mark with which it begins, and nothing stands behind it",
        )
    } else if value.starts_with('[')
        && (message.contains("newline") || message.contains("unclosed"))
    {
        Some("a list has a ] for each [, and nothing stands behind it in its line")
    } else if value.starts_with('{') || message.contains("inline table") {
        Some(
            "braces are such as { scale = [1, 2, 1] }, for a step of a transform; a list is such as [0, 3, 9]",
        )
    } else if begins_with(".+-(<[") || value.starts_with(|first: char| first.is_ascii_digit()) {
        Some(
            "a number is such as 0.8, without a unit and not computed, a list such as [0, 3, 9], with commas",
        )
    } else if value.starts_with(char::is_alphabetic) {
        Some(
            "a number is such as 0.8, not computed, a list such as [0, 3, 9], and a text stands in \
             quotation marks, such as \"red\"",
        )
    } else {
        None
    }
}
