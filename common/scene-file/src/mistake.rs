//! `mistake`: words for a mistake against TOML, for readers who do not know the parser's terms.
//!
//! The parser says what it expects; the characters at the mistake often say what was meant.

use common::text::visible;
use toml::de::Error as ParserError;

use crate::Error;

/// What is right where a backslash stands in double quotation marks.
pub const BACKSLASH: &str = "in double quotation marks \\ begins a special character; write / \
    between folders, or single quotation marks, such as 'models\\bunny.obj'";

/// Beginnings of the parser's errors, and words for each.
const MISTAKES: [(&str, &str); 17] = [
    (
        "duplicate key",
        "this name is taken: a key stands once in its table, spheres, lights and the like have \
         two pairs of brackets, such as [[sphere]], and the shapes of a group stand behind its \
         [[group]]",
    ),
    (
        "invalid inline table element",
        "the braces before this place have no } at their end, or lack a comma",
    ),
    (
        "cannot recurse further",
        "there are too many brackets inside each other",
    ),
    ("recursion limit", "this name has too many parts"),
    (
        "string values must be",
        "a text stands in quotation marks, and a list has commas, such as [0, 1, 0]",
    ),
    (
        "missing comma between array elements",
        "the list before this place has no ] at its end, or lacks a comma",
    ),
    (
        "unclosed array",
        "the list before this place has no ] at its end, or lacks a comma",
    ),
    (
        "missing key for inline table element",
        "the braces before this place have no } at their end, or lack a key",
    ),
    (
        "unclosed inline table",
        "the braces before this place have no } at their end",
    ),
    (
        "unclosed table",
        "the name of a table lacks its ], such as [camera]",
    ),
    (
        "unexpected key or value",
        "a line has one value, and a number has a point, such as 0.8",
    ),
    (
        "key with no value",
        "a line is a key, = and a value, such as radius = 1, or the name of a table, such as [camera]",
    ),
    (
        "invalid unquoted key",
        "keys have the letters a to z and _ only; a NAME with other ones stands in quotation marks",
    ),
    (
        "carriage return",
        "its lines end with CR alone; save it with the line ends LF or CR LF",
    ),
    (
        "extra `=`",
        "between a key and its value stands one =, such as radius = 1",
    ),
    ("invalid literal string", "this text has no ' at its end"),
    (
        "unexpected leading zero",
        "a number has no 0 before its other digits",
    ),
];

/// The error of a text that the parser refuses.
pub fn mistake(text: &str, error: &ParserError) -> Error {
    let span = error.span().unwrap_or_default();
    let at = text.floor_char_boundary(span.start);
    let message = error.message();
    let line_start = text[..at].rfind('\n').map_or(0, |newline| newline + 1);
    let line = text[line_start..].lines().next().unwrap_or_default();
    if let Some((offset, letter)) = line.char_indices().find(|(_, letter)| is_unseen(*letter)) {
        let unseen = letter.escape_unicode();
        let text = format!("here is the character {unseen}, which nobody sees");
        return Error::new(line_start + offset, text);
    }
    if message.starts_with("duplicate key")
        && let Some(text) = duplicate(text, at)
    {
        return Error::new(at, visible(&text));
    }
    if let Some((at, meant)) = meant(text, at, message) {
        let text = meant.to_owned();
        return Error::new(at, text);
    }
    let known = MISTAKES
        .iter()
        .find(|(begin, _)| message.starts_with(begin));
    let text = known.map_or_else(|| message.replace('\n', ", "), |(_, text)| text.to_string());
    let text = visible(&text);
    Error::new(at, text)
}

/// Whether a character has no look, and no meaning in TOML.
fn is_unseen(letter: char) -> bool {
    letter.is_control() && !matches!(letter, '\n' | '\r' | '\t')
}

/// What is said about a name that stands a second time at this place, if the first is found.
fn duplicate(text: &str, at: usize) -> Option<String> {
    let line_start = text[..at].rfind('\n').map_or(0, |newline| newline + 1);
    let line = text[line_start..].lines().next()?.trim();
    let before = || (1_usize..).zip(text[..line_start].lines().map(str::trim));
    let is_named = |line: &str, name: &str| {
        let rest = line.strip_prefix(name);
        rest.is_some_and(|rest| rest.trim_start().starts_with(['=', '.']))
    };
    let Some(header) = line.strip_prefix('[') else {
        let name = text[at..].split(['=', '.', ' ', '\t']).next()?;
        let number_of_header = before().filter(|(_, line)| line.starts_with('[')).last();
        let first = number_of_header.map_or(1, |(number, _)| number);
        let mut of_table = before().filter(|(number, _)| *number >= first);
        let (number, _) = of_table.find(|(_, line)| is_named(line, name))?;
        return Some(format!(
            "{name} is in line {number} already: a key stands once in its table"
        ));
    };
    let name = header.trim_start_matches('[').split(']').next()?;
    let lists = header.starts_with('[');
    let mut headers = before();
    let (number, first) = headers.find(|(_, line)| {
        let inside = line.trim_start_matches('[').split(']').next();
        line.starts_with('[') && inside == Some(name)
    })?;
    Some(match (lists, first.starts_with("[[")) {
        (true, false) => {
            format!("[{name}] in line {number} needs two pairs of brackets, too: [[{name}]]")
        }
        (false, true) => {
            format!("[[{name}]] is in line {number} already: write [[{name}]] here, too")
        }
        _ => format!("[{name}] is in line {number} already, and a table like it stands once"),
    })
}

/// What was probably meant, and where.
fn meant(text: &str, at: usize, message: &str) -> Option<(usize, &'static str)> {
    let line_start = text[..at].rfind('\n').map_or(0, |newline| newline + 1);
    let line_end = text[at..]
        .find('\n')
        .map_or(text.len(), |newline| at + newline);
    let line = &text[line_start..line_end];
    let before = &text[line_start..at];
    if message.contains("escaped value") || message.contains("unicode value") {
        let backslash = before.rfind('\\').map_or(at, |i| line_start + i);
        return Some((backslash, BACKSLASH));
    }
    if message.contains("basic string, expected `\"`") {
        return Some((at, "this text has no \" at its end"));
    }
    let trimmed = line.trim_start();
    let comment = ["//", "--", "/*", ";"]
        .into_iter()
        .find(|mark| trimmed.starts_with(mark));
    if comment.is_some() {
        let start = line_end - trimmed.len();
        return Some((start, "a comment begins with #, such as # a green ball"));
    }
    if message.starts_with("key with no value") && before.trim_end().ends_with(':') {
        return Some((
            at,
            "between a key and its value stands =, such as radius = 1",
        ));
    }
    if message.starts_with("invalid key-value pair") && trimmed.starts_with('{') {
        return Some((
            at,
            "a scene file is no JSON: its tables begin with a name, such as [camera]",
        ));
    }
    let equals = line.find('=')?;
    let start = line_start + equals + 1;
    if start > at {
        return None;
    }
    let value = &text[start..line_end];
    let find = |marks: &[char]| value.find(marks).map(|i| start + i);
    let unquoted = |mark: &str| {
        let i = value.find(mark)?;
        value[..i]
            .matches('"')
            .count()
            .is_multiple_of(2)
            .then_some(start + i)
    };
    if value.trim().is_empty() {
        return Some((at, "there is no value behind the ="));
    }
    if let Some(at) = ["//", "/*", " --"].into_iter().find_map(unquoted) {
        return Some((at, "a comment begins with #, such as # a green ball"));
    }
    if let Some(at) = find(&['−', '–', '—']) {
        return Some((
            at,
            "the minus of a number is -, and this is a longer stroke",
        ));
    }
    if let Some(at) = find(&['“', '”', '„', '‘', '’']) {
        return Some((at, "a text stands in straight quotation marks, \" or '"));
    }
    let bare = value.split('#').next().unwrap_or_default().trim();
    if bare.ends_with(';') {
        let at = start + value.rfind(';').unwrap_or_default();
        return Some((at, "a line ends without a ;"));
    }
    if bare.starts_with(['(', '<']) {
        let at = start + value.find(['(', '<']).unwrap_or_default();
        return Some((at, "a list stands in square brackets, such as [0, 3, 9]"));
    }
    if bare.starts_with(['T', 'F']) && message.contains("boolean") {
        return Some((at, "true and false have small letters"));
    }
    meant_number(&text[start..line_end], start, at, message)
}

/// What was probably meant by a number at this place of a value, which begins at `start`.
fn meant_number(
    value: &str,
    start: usize,
    at: usize,
    message: &str,
) -> Option<(usize, &'static str)> {
    let is_end = |letter: char| letter == ',' || letter == ']' || letter == '#';
    let offset = (at - start).min(value.len());
    let begin = value[..offset]
        .rfind([',', '[', ' ', '='])
        .map_or(0, |i| i + 1);
    let word = value[begin..]
        .split(is_end)
        .next()
        .unwrap_or_default()
        .trim();
    let has_digit = word.contains(|letter: char| letter.is_ascii_digit());
    if message.contains("mantissa") || message.contains("fraction") {
        return Some((
            at,
            "a number has digits on both sides of its point, such as 0.8 or 8.0",
        ));
    }
    if has_digit && word.contains(['*', '/', '^', '(', '+']) {
        return Some((at, "a value is not computed: write the result, such as 0.8"));
    }
    let after = word.trim_start_matches(|letter: char| {
        letter.is_ascii_digit() || matches!(letter, '.' | '-' | '+')
    });
    let unit = after.trim();
    let is_unit = |letter: char| letter.is_alphabetic() || matches!(letter, '°' | '%' | '"' | '\'');
    if has_digit && after != word && !unit.is_empty() && unit.chars().all(is_unit) {
        let at = start + begin + value[begin..].find(unit).unwrap_or_default();
        return Some((
            at,
            "a number has no unit; angles are in degrees, such as 36",
        ));
    }
    None
}
