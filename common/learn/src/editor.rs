//! `editor`: the settings of rust-analyzer for the students' files.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

use common::text;

use crate::files;

/// Its builds and the checks do not wait for each other, and only the checks report errors.
const SETTINGS: &str = r#"{
  "rust-analyzer.cargo.targetDir": true,
  "rust-analyzer.checkOnSave": false
}"#;

/// Writes the settings, unless the file has others. Returns its path.
pub fn write_settings() -> Result<String, String> {
    let file = files::shortest(".vscode/settings.json");
    let path = text::path(&file);
    match write_new(&file) {
        Ok(()) => Ok(path),
        Err(error) => Err(format!("{path}: {error}; add to it\n{SETTINGS}")),
    }
}

/// Writes the settings into a file that does not exist yet.
fn write_new(file: &Path) -> io::Result<()> {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder)?;
    }
    writeln!(File::create_new(file)?, "{SETTINGS}")
}
