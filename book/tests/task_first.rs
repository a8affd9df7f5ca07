//! A reader meets a task before the lesson's code for it: each fold with code stands behind a link to
//! the page of exercises, and no other fold is between them.

use crate::files::{Files, complaint};

const FOLD: &str = "<details class=\"lesson\">";
const END: &str = "</details>";

/// The folds of the chapters before which there is no task.
pub fn complaints(files: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut folds = 0;
    for (page, text) in files.pages() {
        let mut from = 0;
        while let Some(start) = text[from..].find(FOLD).map(|at| from + at) {
            let length = text[start..].find(END).unwrap_or(text.len() - start);
            let before = &text[from..start];
            // Several folds may follow one task.
            let follows_fold = from > 0 && before.trim().is_empty();
            let has_code = text[start..start + length].contains("{{#include");
            folds += usize::from(has_code);
            if has_code && !follows_fold && !before.contains("-exercises.md#") {
                let wrong = "this code stands before its task";
                complaints.push(complaint(page, text, start, wrong));
            }
            from = text.len().min(start + length + END.len());
        }
    }
    assert!(folds > 20, "only {folds} folds");
    complaints
}
