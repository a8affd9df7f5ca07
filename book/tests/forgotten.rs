//! What is written and then forgotten compiles all the same: the description of a type without its
//! row, and a file of tests that no other file names.

use crate::files::Files;

/// The descriptions of types, in `program/kinds.rs` of a stage, that no row names.
pub fn types_without_a_row(files: &Files) -> Vec<String> {
    let mut found = Vec::new();
    for (path, text) in files.rust() {
        if !path.contains("/src/program/kinds") {
            continue;
        }
        for line in text.lines() {
            let Some((of, name)) = line
                .strip_prefix("impl ")
                .and_then(|line| line.strip_suffix(" {"))
                .and_then(|line| line.split_once(" for "))
            else {
                continue;
            };
            // The row may be that of a stage above, if only its scene files name the type.
            let row = format!("::of::<{name}>");
            let is_named = files.rust().any(|(_, text)| text.contains(&row));
            if of.ends_with("Kind") && !is_named {
                found.push(format!("{path}: {name} has an `impl {of}`, but no row"));
            }
        }
    }
    found
}

/// The files of a stage's tests that are not compiled.
pub fn tests_without_a_name(files: &Files) -> Vec<String> {
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
