//! Writes files so that each is complete or absent.

use std::fs::{self, OpenOptions};
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::time::Duration;

use tempfile::NamedTempFile;

use crate::Error;

/// Prefix and suffix of temporary files.
const TEMPORARY: [&str; 2] = [".saving-", ".part"];

/// Temporary files older than this were left behind by a program that was killed.
const LEFT_BEHIND: Duration = Duration::from_hours(1);

/// Writes a file of this name, and replaces an older one.
///
/// It is written under another name in the same folder and then renamed. So other
/// programs always find the old file or the complete new one, even if this program is
/// killed. If `path` is a symbolic link, it stays, and its target is written.
pub fn write(path: &Path, content: impl Read) -> Result<(), Error> {
    let (file, end) = unnamed(path, content)?;
    let named = file.persist(end).map(drop);
    named.map_err(|error| cannot_write(path, &error.error))
}

/// Like [`write()`], but if there already is a file of this name, keeps it and returns
/// false.
pub fn write_new(path: &Path, content: impl Read) -> Result<bool, Error> {
    let (file, end) = unnamed(path, content)?;
    match file.persist_noclobber(end) {
        Ok(_) => Ok(true),
        Err(error) if error.error.kind() == ErrorKind::AlreadyExists => Ok(false),
        Err(error) => Err(cannot_write(path, &error.error)),
    }
}

/// An error if a file cannot be written; for a check before there is anything to
/// write. Leaves no file behind.
pub fn check_writable(path: &Path) -> Result<(), Error> {
    temporary_file(path).map(drop)
}

/// The error that `path` cannot be written, with a remedy.
#[must_use]
pub fn cannot_write(path: &Path, error: &io::Error) -> Error {
    let reason = match error.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            format!("there is no room left; make some, or write elsewhere ({error})")
        }
        ErrorKind::FileTooLarge => {
            format!("it is larger than a file may be there; write less, or elsewhere ({error})")
        }
        _ => error.to_string(),
    };
    refusal(path, reason)
}

fn refusal(path: &Path, reason: impl Into<String>) -> Error {
    Error::Write {
        path: path.to_owned(),
        reason: reason.into(),
    }
}

/// A complete temporary file, which is deleted unless it gets its final name, the
/// second value.
fn unnamed(path: &Path, mut content: impl Read) -> Result<(NamedTempFile, PathBuf), Error> {
    let (mut file, end) = temporary_file(path)?;
    remove_left_behind(folder_of(&end));
    // Errors of the inner file do not contain the temporary name.
    let inner = file.as_file_mut();
    let copied = io::copy(&mut content, inner)
        // Some file systems rename first and write later: without this, a power
        // failure would leave an empty file where the old one was. It took 1 to
        // 2 ms for 8 kB and up to 30 ms for 22 MB. The folder needs none: until
        // the name is on the disk, the old file is.
        .and_then(|_| inner.sync_all());
    copied.map_err(|error| cannot_write(path, &error))?;
    Ok((file, end))
}

/// An empty temporary file, which is deleted unless it gets its final name, the second
/// value: `path`, or its target if it is a link.
fn temporary_file(path: &Path) -> Result<(NamedTempFile, PathBuf), Error> {
    let end = end_of_links(path)?;
    let folder = folder_of(&end);
    let shown = folder.display();
    if !folder.exists() {
        let reason = format!("there is no folder {shown}; create it first");
        return Err(refusal(path, reason));
    }
    if !folder.is_dir() {
        let reason = format!("{shown} is a file, not a folder");
        return Err(refusal(path, reason));
    }
    check_replaceable(&end).map_err(|reason| refusal(path, reason))?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(TEMPORARY[0]).suffix(TEMPORARY[1]);
    // Temporary files are private by default; a picture gets the usual permissions.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(folder).map_err(|error| {
        let reason = format!("no file can be made in {shown} ({})", error.kind());
        refusal(path, reason)
    })?;
    Ok((file, end))
}

/// The target of a link, or the path itself. Renaming to a link would replace the link
/// and not its target.
fn end_of_links(path: &Path) -> Result<PathBuf, Error> {
    let mut end = path.to_owned();
    // Linux follows as many links.
    for _ in 0..40 {
        match fs::read_link(&end) {
            Ok(next) => end = folder_of(&end).join(next),
            Err(_) => return Ok(end),
        }
    }
    Err(refusal(path, "it is a link that leads nowhere"))
}

/// An error if this file must not be replaced. Renaming would only check the
/// permissions of the folder.
fn check_replaceable(path: &Path) -> Result<(), &'static str> {
    let Ok(found) = fs::metadata(path) else {
        return Ok(());
    };
    if found.is_dir() {
        return Err("a folder has this name");
    }
    if !found.is_file() {
        return Err("it is a device or a pipe, not a file; choose another name");
    }
    match OpenOptions::new().write(true).open(path) {
        Err(error) if error.kind() == ErrorKind::PermissionDenied => {
            Err("the file of this name may not be changed; choose another")
        }
        _ => Ok(()),
    }
}

/// Removes old temporary files from the folder.
fn remove_left_behind(folder: &Path) {
    let [begin, end] = TEMPORARY;
    for entry in folder.read_dir().into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        let written = || entry.metadata().and_then(|found| found.modified());
        let is_old = || {
            let age = written().ok().and_then(|time| time.elapsed().ok());
            age.is_some_and(|age| age > LEFT_BEHIND)
        };
        if name.starts_with(begin) && name.ends_with(end) && is_old() {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// The folder that a file is in.
#[must_use]
pub fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

#[cfg(test)]
mod tests;
