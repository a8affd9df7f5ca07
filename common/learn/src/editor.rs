//! `editor`: the settings of rust-analyzer for the students' files.

use std::fs::{self, File};
use std::io::Write;

use crate::files;

/// Its builds and the checks do not wait for each other, and only the checks report errors.
const SETTINGS: &str = r#"{
  "rust-analyzer.cargo.targetDir": true,
  "rust-analyzer.checkOnSave": false
}"#;

/// Writes the settings, unless the file has others. Returns its path.
pub fn write_settings() -> Result<String, String> {
    let file = files::shortest(".vscode/settings.json");
    let folder = file.parent().map_or(Ok(()), fs::create_dir_all);
    let created = folder.and_then(|()| File::create_new(&file));
    let written = created.and_then(|mut file| writeln!(file, "{SETTINGS}"));
    let path = file.display().to_string();
    written.map_err(|error| format!("{path}: {error}; add to it\n{SETTINGS}"))?;
    Ok(path)
}
