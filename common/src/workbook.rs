//! `workbook`: the folder of the workbook, for programs that read its files.

use std::env;
use std::path::{Path, PathBuf};

/// The folder that has this file: the current one or one above it, as Cargo looks for a workspace; else the one
/// in which the program was built, of which a sentence on stderr says so.
#[must_use]
pub fn with_file(file: &str, built: &Path) -> PathBuf {
    let here = env::current_dir().unwrap_or_default();
    let mut folders = here.ancestors();
    let found = folders.find(|folder| folder.join(file).is_file());
    found.map_or_else(
        || {
            eprintln!("note: the workbook is {}", crate::text::path(built));
            built.to_owned()
        },
        Path::to_owned,
    )
}
