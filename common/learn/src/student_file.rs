//! The student's file of an exercise, which begins as a copy of the starter.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use common::text;

use crate::exercise::Exercise;
use crate::files::{shortest, with_path};
use crate::starter::starter;

/// The path of the student's file.
pub fn path(e: &Exercise) -> PathBuf {
    shortest(&format!("{}/exercises/{}.rs", e.stage, e.name))
}

/// When the student's file was saved, and its length; none if there is no file.
pub type Saved = Option<(SystemTime, u64)>;

/// Tells a saved file from the one before.
pub fn saved(exercise: &Exercise) -> Saved {
    let file = fs::metadata(path(exercise)).ok()?;
    Some((file.modified().ok()?, file.len()))
}

/// Whether the student has changed the file.
pub fn is_begun(exercise: &Exercise) -> bool {
    let Ok(yours) = fs::read(path(exercise)) else {
        return false;
    };
    starter(exercise).is_ok_and(|starter| starter.as_bytes() != yours)
}

/// Writes the starter, if the student has no file yet.
pub fn begin(exercise: &Exercise) -> Result<(), String> {
    let yours = path(exercise);
    if yours.exists() {
        return Ok(());
    }
    if yours.is_symlink() {
        let yours = text::path(&yours);
        return Err(format!(
            "{yours} is a link to a file that is missing; delete the link, or write that file"
        ));
    }
    if let Some(near) = near_name(&yours, exercise.name) {
        let [near, yours] = [near, yours].map(|path| text::path(&path));
        return Err(format!("there is {near}; rename it to {yours}"));
    }
    fs::write(&yours, starter(exercise)?).map_err(with_path(&yours))
}

/// A file beside the student's whose name an editor or a browser may have made of it, such as `mean.rs.txt`,
/// `Mean.rs` or `mean (1).rs`.
fn near_name(yours: &Path, exercise: &str) -> Option<PathBuf> {
    let plain = |name: &str| {
        let letters = name.chars().filter(|c| c.is_alphanumeric());
        letters.collect::<String>().to_lowercase()
    };
    let exercise = plain(exercise);
    let mut files = fs::read_dir(yours.parent()?).ok()?.flatten();
    let near = files.find(|file| {
        let name = plain(&file.file_name().to_string_lossy());
        let rest = name.strip_prefix(&exercise);
        let rest = rest.map(|rest| rest.trim_start_matches(|c: char| c.is_ascii_digit()));
        matches!(rest, Some("rs" | "rstxt")) && file.path() != yours
    });
    near.map(|file| file.path())
}

/// Renames the student's file, and copies the starter. Returns where both are.
pub fn reset(exercise: &Exercise) -> Result<String, String> {
    let yours = path(exercise);
    let mut words = format!("the starter: {}", text::path(&yours));
    if is_begun(exercise) {
        let backup = free_backup(&yours);
        fs::rename(&yours, &backup).map_err(with_path(&yours))?;
        words += "\nyour file is kept: ";
        words += &text::path(&backup);
    }
    begin(exercise)?;
    Ok(words)
}

/// The first name of a backup that no file has.
fn free_backup(file: &Path) -> PathBuf {
    let mut number = 1;
    loop {
        let backup = file.with_extension(format!("{number}.bak"));
        if !backup.exists() && !backup.is_symlink() {
            return backup;
        }
        number += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_of_nearly_the_name_is_found_and_no_other() {
        let folder = tempfile::tempdir().unwrap();
        let yours = folder.path().join("set_pixel.rs");
        for other in ["set_pixel.1.bak", "set_pixels.rs", "pixel.rs", "line.rs"] {
            fs::write(folder.path().join(other), "").unwrap();
        }
        assert_eq!(near_name(&yours, "set_pixel"), None);
        for near in [
            "set_pixel.rs.txt",
            "Set_Pixel.rs",
            "set-pixel.rs",
            "set_pixel (1).rs",
        ] {
            let near = folder.path().join(near);
            fs::write(&near, "").unwrap();
            assert_eq!(near_name(&yours, "set_pixel"), Some(near.clone()));
            fs::remove_file(near).unwrap();
        }
    }
}
