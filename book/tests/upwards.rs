//! A crate compiles and reads its own files only: a path that leads out of it would tie it to the
//! folder in which it lies.

use crate::files::{Files, complaint, resolve};

/// What compiles or reads a file while a crate is built.
const READING: [&str; 4] = [
    "include!(\"",
    "include_str!(\"",
    "include_bytes!(\"",
    "#[path = \"",
];

/// Its macro has paths within the crate that calls it.
const MACROS: &str = "common/testing/src/exercises.rs";

/// The places with a path that leads out of their crate.
pub fn complaints(files: &Files) -> Vec<String> {
    let mut found = Vec::new();
    for (path, text) in files.rust().filter(|(path, _)| *path != MACROS) {
        let folder = crate_folder(files, path);
        for reading in READING {
            for (at, _) in text.match_indices(reading) {
                let name = text[at + reading.len()..].split('"').next();
                let target = name.and_then(|name| resolve(path, name));
                if !target.is_some_and(|target| target.starts_with(folder)) {
                    let mistake = format!("leads out of the crate in {folder}");
                    found.push(complaint(path, text, at, &mistake));
                }
            }
        }
    }
    found
}

/// The folder of the crate of a file, with a slash at its end.
fn crate_folder<'a>(files: &Files, path: &'a str) -> &'a str {
    let mut folder = path;
    while let Some((above, _)) = folder.trim_end_matches('/').rsplit_once('/') {
        folder = &path[..=above.len()];
        if files.text(&format!("{folder}Cargo.toml")).is_some() {
            return folder;
        }
    }
    ""
}
