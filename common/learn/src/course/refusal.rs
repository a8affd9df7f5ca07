//! `refusal`: finds files that call the lesson in the place of code of their own.
//!
//! It compares words: a macro can hide a call, and nothing finds the lesson's text in another
//! file.

use crate::exercise::Exercise;

/// For each exercise, words that its code has only if it calls the lesson.
const LESSONS: &str = include_str!("../../handout/lessons.txt");

/// Why a file is not judged: it takes its answers from the lesson.
pub fn refusal(e: &Exercise, text: &str) -> Option<String> {
    let text: String = text.split_whitespace().collect();
    let text = text.replace("usecrate::prelude::*;", ";");
    let stages = (1..=9).map(|stage| format!("a0{stage}_"));
    let paths = ["crate::", "super::", "include", "fs::", "#[path", "extern"].map(str::to_owned);
    let lesson = LESSONS
        .lines()
        .find_map(|line| line.strip_prefix(e.name)?.strip_prefix(' '));
    let calls = lesson
        .into_iter()
        .flat_map(|line| line.split(' '))
        .map(str::to_owned);
    let word = stages
        .chain(paths)
        .chain(calls)
        .find(|word| text.contains(word))?;
    Some(format!(
        "refused: it contains `{word}`; write your own code, with the names of the prelude"
    ))
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
            // The functions by which the check calls the lesson.
            let check = files::read(&format!("{}/tests/exercises/{}.rs", e.stage, e.name)).unwrap();
            let calls = check.split("pub fn check").next().unwrap();
            let is_called = LESSONS
                .lines()
                .any(|line| line.split(' ').next() == Some(e.name));
            assert!(!is_called || refusal(e, calls).is_some(), "{}", e.name);
        }
    }
}
