//! A stage knows the engine and the scene files in few places only.

use crate::files::Files;

/// The crates that lessons and instruments do not know.
const CRATES: [&str; 3] = ["engine::", "scene_file", "measure::"];

/// The places of a stage that know them: the rows of its types, and the choice of the renderer.
const KNOWING: [&str; 4] = [
    "/src/kinds.rs",
    "/src/kinds/",
    "/src/stage.rs",
    "/src/view.rs",
];

/// The other places that name one of these crates.
pub fn complaints(files: &Files) -> Vec<String> {
    let mut found = Vec::new();
    for (path, text) in files.rust() {
        let is_stage = path.starts_with("a0") && path.matches("/src/").count() == 1;
        let measures_or_tests = path.contains("/lab/") || path.contains("/tests/");
        if !is_stage || measures_or_tests || KNOWING.iter().any(|part| path.contains(part)) {
            continue;
        }
        for (number, line) in (1..).zip(text.lines()) {
            // A comment may tell of them.
            let code = line.split("//").next().unwrap_or_default();
            if let Some(name) = CRATES.iter().find(|name| code.contains(**name)) {
                found.push(format!("{path}:{number}: {name} belongs to kinds.rs"));
            }
        }
    }
    found
}
