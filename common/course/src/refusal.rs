//! `refusal`: why a file is not judged, because it calls the lesson instead of code of its own.
//!
//! It is found by its words: a macro can hide a call, and nothing finds the lesson's text in another
//! file.

use learn::exercise::Exercise;

/// For each exercise, words that its code has only if it calls the lesson, and such words of all.
const LESSONS: &str = include_str!("../handout/lessons.txt");

/// Why a file is not judged.
pub fn refusal(e: &Exercise, text: &str) -> Option<String> {
    let text: String = text.split_whitespace().collect();
    let text = text.replace("usecrate::prelude::*;", ";");
    let mut forbidden = words("*").chain(words(e.name));
    let word = forbidden.find(|word| text.contains(word))?;
    Some(format!(
        "refused: it contains `{word}`; write your own code, with the names of the prelude"
    ))
}

/// The words after a name in the list of lessons.
fn words(name: &str) -> impl Iterator<Item = &'static str> {
    let after_name = |line: &'static str| line.strip_prefix(name)?.strip_prefix(' ');
    let words = LESSONS.lines().find_map(after_name);
    words.unwrap_or_default().split_whitespace()
}

#[cfg(test)]
mod tests {
    use learn::files;

    use super::*;

    #[test]
    fn files_that_take_the_lesson_are_refused_and_starters_are_not() {
        for e in learn::exercise::read_all().unwrap() {
            let starter = files::starter(e).unwrap();
            assert_eq!(refusal(e, &starter), None, "{}", e.name);
            let lesson = format!("pub use {}::*;\n{starter}", e.stage.replace('-', "_"));
            assert!(refusal(e, &lesson).is_some(), "{}", e.name);
        }
    }

    #[test]
    fn files_that_start_programs_or_read_files_are_refused() {
        let e = learn::exercise::find("sphere").unwrap();
        for line in [
            "std::process::Command::new(\"cat\")",
            "use std::process;",
            "use std::{f64::consts::PI, process as p};",
            "std::fs::read(\"answers\")",
            "std :: fs :: File",
        ] {
            assert!(refusal(e, line).is_some(), "{line}");
        }
        for line in [
            "let processed = 1; let offset = 2;",
            "use std::{f64::consts::PI, mem};",
        ] {
            assert_eq!(refusal(e, line), None, "{line}");
        }
    }
}
