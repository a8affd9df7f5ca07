//! `mistake`: a mistake against TOML, in the parser's words, with the line in which it is.

use common::text;
use toml::de::Error as ParserError;

use crate::Error;

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
            let text = format!("here is the character {unseen}, which nobody sees");
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
    let said = error.message().replace('\n', ", ");
    // The parser guesses these words, of which a scene file takes none.
    let is_guess = said.ends_with("expected `nan`") || said.ends_with("expected `inf`");
    let message = if is_guess { "invalid value" } else { &said };
    let hint = hint(message, line).map_or(String::new(), |hint| format!(" ({hint})"));
    let (message, line) = (text::visible(message), text::name(line.trim()));
    Error::new(at, format!("{message}{hint}: {line}"))
}

/// What was probably meant.
fn hint(message: &str, line: &str) -> Option<&'static str> {
    let value = line.split_once('=').map_or("", |(_, value)| value.trim());
    if message.starts_with("duplicate key") {
        Some(
            "a key stands once in its table, and a table of which there may be several has two \
             pairs of brackets, such as [[sphere]]",
        )
    } else if message.contains("between array elements") {
        Some("the list before this place has no ] at its end, or lacks a comma")
    } else if line.contains('\\') {
        Some(BACKSLASH)
    } else if ["//", "/*", "--", ";"]
        .iter()
        .any(|mark| line.contains(mark))
    {
        Some("a comment begins with #, and nothing else stands behind a value")
    } else if value.starts_with(|first: char| first.is_ascii_digit() || ".+-(".contains(first)) {
        Some("a number is such as 0.8, without a unit and not computed, a list such as [0, 3, 9]")
    } else if value.starts_with(char::is_alphabetic) && !message.contains("quoted") {
        Some(
            "a number is such as 0.8, not computed, a list such as [0, 3, 9], and a text stands in \
             quotation marks, such as \"red\"",
        )
    } else {
        None
    }
}
