//! A file of tests that no other file names is not compiled, and the compiler does not say so.

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
