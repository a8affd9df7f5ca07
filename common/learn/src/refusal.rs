//! `refusal`: why a file does not count, because it calls the lesson instead of code of its own. The grader does not
//! judge it, and `cargo learn` says so.
//!
//! It is found by its words: a macro can hide a call, and nothing finds the lesson's text in another
//! file.

use proc_macro2::{Group, Literal, TokenStream, TokenTree};

use crate::exercise::Exercise;
use crate::tokens;

/// For each exercise, words that its code has only if it calls the lesson, and such words of all.
const LESSONS: &str = include_str!("lessons.txt");

/// Why a file does not count, in words for the student; none if it does.
#[must_use]
pub fn refusal(e: &Exercise, text: &str) -> Option<String> {
    let mut text = joined(text);
    // A file may use its own items in a module for tests.
    for harmless in ["use~crate::prelude::*;", "use~super::*;"] {
        text = text.replace(harmless, ";");
    }
    let mut forbidden = words("*").chain(words(e.name));
    let word = forbidden.find(|word| has(&text, word))?;
    let word = word.replace('~', " ");
    Some(format!(
        "refused: it contains `{word}`; write your own code, with the names of the prelude"
    ))
}

/// Whether a letter is part of a name.
fn is_of_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

/// The tokens, of which the texts are empty.
fn without_texts(tokens: TokenStream) -> TokenStream {
    let without_text = |token| match token {
        TokenTree::Literal(literal) if literal.to_string().contains(['"', '\'']) => {
            Literal::string("").into()
        }
        TokenTree::Group(bracket) => {
            Group::new(bracket.delimiter(), without_texts(bracket.stream())).into()
        }
        other => other,
    };
    tokens.into_iter().map(without_text).collect()
}

/// The code without space and comments, and with `~` between two names; none of a text that does not compile.
fn joined(text: &str) -> String {
    let tokens = tokens::read(text).unwrap_or_default();
    // Any name may be written as a raw one.
    let code = without_texts(tokens).to_string().replace("r#", "");
    let mut joined = String::new();
    for word in code.split_whitespace() {
        if joined.ends_with(is_of_name) && word.starts_with(is_of_name) {
            joined.push('~');
        }
        joined += word;
    }
    joined
}

/// Whether a text has a word that neither begins nor ends within a longer name; one that ends with `_` is
/// the beginning of names.
fn has(text: &str, word: &str) -> bool {
    text.match_indices(word).any(|(at, _)| {
        let (before, after) = (&text[..at], &text[at + word.len()..]);
        let begins_within = word.starts_with(is_of_name) && before.ends_with(is_of_name);
        let ends_within = word.ends_with(char::is_alphanumeric) && after.starts_with(is_of_name);
        !begins_within && !ends_within
    })
}

/// The words after a name in the list of lessons.
fn words(name: &str) -> impl Iterator<Item = &'static str> {
    let after_name = |line: &'static str| line.strip_prefix(name)?.strip_prefix(' ');
    let words = LESSONS.lines().find_map(after_name);
    words.unwrap_or_default().split_whitespace()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files;

    #[test]
    fn files_that_take_the_lesson_are_refused_and_starters_are_not() {
        for e in crate::exercise::read_all().unwrap() {
            let starter = files::starter(e).unwrap();
            assert_eq!(refusal(e, &starter), None, "{}", e.name);
            let lesson = format!("pub use {}::*;\n{starter}", e.stage.replace('-', "_"));
            assert!(refusal(e, &lesson).is_some(), "{}", e.name);
        }
    }

    #[test]
    fn files_that_start_programs_or_read_files_are_refused() {
        let e = crate::exercise::find("sphere").unwrap();
        for line in [
            "std::process::Command::new(\"cat\")",
            "use std::process;",
            "use std::{f64::consts::PI, process as p};",
            "std::fs::read(\"answers\")",
            "std :: fs :: File",
            "use std::{fs as f};",
            "const ANSWERS: &str = include_str!(\"answers\");",
            "let quote = '\"'; std::fs::read(\"a\"); let other = '\\\"';",
            "/* /* */ */ std::net::connect()",
            "let a = r\"\\\"; std::fs::read(b); let c = \"\";",
            "let a = c\"\\\\\"; std::fs::read(b); let c = br#\"\"#;",
            "use std::r#fs as files;",
            "fn f<'a>(c: &'a str) { let q = b'\"'; std::fs::read(c); }",
        ] {
            assert!(refusal(e, line).is_some(), "{line}");
        }
        for line in [
            "let processed = 1; let offset = 2;",
            "use std::{f64::consts::PI, mem};",
            "use prefs::path; let external = prefs::path(\"included\");",
            "// It includes what std::fs::read does.",
            "let a = 1.0; // Sphere is in super::x and std::fs.",
            "/* use std::fs; /* std::process */ std::net */ let a = 1;",
            "let a = \"std::fs \\\" std::net\"; let b = r#\"use \"std::fs\"\"#; let r = 1;",
            "mod tests { use super::*; }",
        ] {
            assert_eq!(refusal(e, line), None, "{line}");
        }
    }
}
