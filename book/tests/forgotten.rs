//! A file of tests that no other file names is not compiled, and an exercise that no list names is seen by
//! nobody; the compiler does not say so.

use crate::files::Files;

/// The files of a stage's tests that are not compiled.
pub fn complaints(files: &Files) -> Vec<String> {
    let mut found = Vec::new();
    for (path, _) in files.rust() {
        let Some((folder, file)) = path.rsplit_once('/') else {
            continue;
        };
        let name = file.trim_end_matches(".rs");
        if !path.contains("/tests/stage/") || name == "main" {
            continue;
        }
        let parent = if folder.ends_with("/tests/stage") {
            format!("{folder}/main.rs")
        } else {
            format!("{folder}.rs")
        };
        let declares = |text: &str| text.contains(&format!("mod {name};"));
        if !files.text(&parent).is_some_and(declares) {
            found.push(format!("{path}: {parent} lacks `mod {name};`"));
        }
    }
    found
}

/// The check, the row, or the section in the book that a solution of an exercise lacks.
pub fn exercises(files: &Files) -> Vec<String> {
    let mut found = Vec::new();
    for (path, _) in files.rust() {
        let Some((stage, file)) = path.split_once("/exercises/solutions/") else {
            continue;
        };
        let name = file.trim_end_matches(".rs");
        let task = format!("cargo learn {name}\n");
        if !files.pages().any(|(_, text)| text.contains(&task)) {
            found.push(format!("{path}: no page of the book has `{}`", task.trim()));
        }
        for (list, entry) in [
            ("tests/exercises/main.rs", format!("mod {name};")),
            ("exercises/exercises.toml", format!("name = \"{name}\"\n")),
        ] {
            let list = format!("{stage}/{list}");
            if !files.text(&list).is_some_and(|text| text.contains(&entry)) {
                found.push(format!("{path}: {list} lacks `{}`", entry.trim()));
            }
        }
    }
    found
}
