//! Lines and numbers of text files, whatever system wrote them.

use std::borrow::Cow;

/// Most characters of a line that an error quotes.
const MOST_QUOTED: usize = 80;

/// The lines of a text, which end with LF, CR LF or CR.
pub fn lines(text: &str) -> impl Iterator<Item = &str> {
    let lines = text.split('\n');
    lines.flat_map(|line| line.strip_suffix('\r').unwrap_or(line).split('\r'))
}

/// A number. NaN and infinity may have the spelling of any program, such as `-nan(ind)` and
/// `1.#QNAN` of Windows.
pub fn number(word: &str) -> Option<f64> {
    word.parse().ok().or_else(|| not_a_number(word))
}

/// NaN or infinity, spelt as no number of Rust.
fn not_a_number(word: &str) -> Option<f64> {
    let lower = word.trim_start_matches(['+', '-']).to_ascii_lowercase();
    let sign = if word.starts_with('-') { -1.0 } else { 1.0 };
    // C adds where the NaN comes from, as in nan(ind), nan(snan) or nan(0x8000000000000).
    let is_nan = matches!(
        lower.as_str(),
        "qnan" | "snan" | "nanq" | "nans" | "ind" | "1.$"
    ) || lower.starts_with("nan(")
        || is_windows_nan(&lower);
    if lower.starts_with("1.#inf") || lower.starts_with("1,#inf") {
        return Some(sign * f64::INFINITY);
    }
    is_nan.then_some(f64::NAN)
}

/// Whether a word is a number of the C library of Windows before 2015 that is none, such as
/// `1.#IND`, or `1.#J` if few digits are printed.
fn is_windows_nan(word: &str) -> bool {
    let after = word.strip_prefix("1.#").or(word.strip_prefix("1,#"));
    after.is_some_and(|name| {
        let name = name.trim_end_matches(|c: char| c.is_ascii_digit());
        matches!(
            name.to_ascii_lowercase().as_str(),
            "ind" | "qnan" | "snan" | "inf" | "j" | "r"
        )
    })
}

/// The line before its comment, which begins with `#`. Windows writes `1.#IND` for a number.
pub fn without_comment(line: &str) -> &str {
    for (at, _) in line.match_indices('#') {
        let start = line[..at].rfind(char::is_whitespace).map_or(0, |i| i + 1);
        let word = line.get(start..).unwrap_or_default();
        let word = word.split_whitespace().next().unwrap_or_default();
        if !is_windows_nan(word.trim_start_matches(['+', '-'])) {
            return &line[..at];
        }
    }
    line
}

/// A line in an error: without control characters, and not too long.
pub fn quoted(line: &str) -> Cow<'_, str> {
    if line.len() <= MOST_QUOTED && !line.contains(char::is_control) {
        return Cow::Borrowed(line);
    }
    let printable = |c: char| if c.is_control() { ' ' } else { c };
    let mut short: String = line.chars().take(MOST_QUOTED).map(printable).collect();
    if line.chars().nth(MOST_QUOTED).is_some() {
        short += "...";
    }
    Cow::Owned(short)
}
