//! `refusal`: why a file does not count, because it uses what it is to write, or reads other files. The grader
//! does not judge it, and `cargo learn` says so.
//!
//! It is found by its words: a macro can hide a use, and nothing finds the lesson's text in another
//! file.

mod code_text;
mod lessons;
#[cfg(test)]
mod tests;
mod use_search;

use crate::exercise::Exercise;
use crate::tokens;
use code_text::{has, is_of_name, joined};
use lessons::words_of;
use use_search::UseSearch;

/// Why a file does not count, in words for the student; none if it does.
#[must_use]
pub fn refusal(e: &Exercise, text: &str) -> Option<String> {
    // The compiler says what is wrong with other code.
    let tokens = tokens::read(text).ok()?;
    let text = joined(tokens.clone());
    if let Some(word) = words_of("*").find(|word| has(&text, word)) {
        let word = word.replace('~', " ");
        return Some(format!(
            "refused: it contains `{word}`; your code needs nothing but the prelude"
        ));
    }
    let used = words_of(e.name).find(|name| {
        if !name.chars().all(is_of_name) {
            return has(&text, name);
        }
        let search = UseSearch { name, text: &text };
        search.finds_use(tokens.clone(), false, true)
    })?;
    let used = used.trim_end_matches('(');
    Some(format!(
        "refused: it uses `{used}` of the workbook or of a library, which does what the exercise asks for; \
         write your own code. In a course, such a file needs a look"
    ))
}
