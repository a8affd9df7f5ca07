//! What is said about a program that has drawn no picture.

use std::path::Path;

use common::text;

/// The sentence about a program that ends well without a picture, but perhaps with another one.
#[must_use]
pub fn no_picture(other: Option<&Path>) -> String {
    let other = other.map_or(String::new(), |other| {
        format!(", but {}", text::path(other))
    });
    format!(
        "the program writes no picture into the file after -o{other}: does `main` begin with the lines of \
         book/src/part-two.md?"
    )
}

/// Why a program has ended with an error, from what it has printed, as a sentence about it.
#[must_use]
pub fn last_words(printed: &str) -> String {
    if printed.contains("has overflowed its stack") {
        return "the stack overflows, probably by a recursion without end".to_owned();
    }
    if printed.contains("memory allocation of ") {
        return "the program needs more memory than its limit".to_owned();
    }
    if let Some((_, panic)) = printed.split_once("panicked at ") {
        let lines = panic.lines().take_while(|line| !line.starts_with("note: "));
        let lines: Vec<_> = lines.map(str::trim).collect();
        return format!(
            "the program panics at {}",
            text::name(lines.join(" ").trim_end())
        );
    }
    let mut lines = printed.lines().rev();
    match lines.find(|line| !line.trim().is_empty()) {
        Some(last) => format!(
            "the program ends with an error: {}",
            text::visible(last.trim())
        ),
        None => "the program ends with an error, without a word".to_owned(),
    }
}
