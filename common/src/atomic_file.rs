//! Writes files so that each is complete or absent.

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

#[cfg(unix)]
use rustix::process::{Resource, getrlimit};
use tempfile::NamedTempFile;

use crate::{Error, text};

/// Writes a file of this name, or that a link of this name leads to, and replaces an older one,
/// whose permissions it gets.
///
/// It is written under another name in the same folder and then renamed. So other
/// programs always find the old file or the complete new one.
pub fn write(path: &Path, content: &[u8]) -> Result<(), Error> {
    let path = &target(path);
    let mut file = temporary_file(path)?;
    // Beyond its limit, Unix ends the process, and the temporary file would stay.
    #[cfg(unix)]
    if let Some(most) = getrlimit(Resource::Fsize).current
        && content.len() as u64 > most
    {
        return Err(cannot_write(path, &ErrorKind::FileTooLarge.into()));
    }
    // Errors of the inner file do not contain the temporary name.
    let inner = file.as_file_mut();
    // Some file systems rename first and write later: without `sync_all`, a power
    // failure would leave an empty file where the old one was.
    let written = inner.write_all(content).and_then(|()| {
        if let Ok(old) = fs::metadata(path) {
            inner.set_permissions(old.permissions())?;
        }
        inner.sync_all()
    });
    written.map_err(|error| cannot_write(path, &error))?;
    let named = file.persist(path).map(drop);
    named.map_err(|error| cannot_write(path, &error.error))
}

/// An error if a file cannot be written; for a check before there is anything to
/// write. Leaves no file behind.
pub fn check_writable(path: &Path) -> Result<(), Error> {
    temporary_file(&target(path)).map(drop)
}

/// Most links that lead from one to the next, as on Linux.
const MAX_LINKS: usize = 40;

/// The file that a name leads to through links. It may be missing.
fn target(path: &Path) -> PathBuf {
    let mut target = path.to_owned();
    for _ in 0..MAX_LINKS {
        match fs::read_link(&target) {
            Ok(next) => target = target.with_file_name(next),
            Err(_) => break,
        }
    }
    target
}

/// The error that `path` cannot be written, with a remedy.
#[must_use]
pub fn cannot_write(path: &Path, error: &io::Error) -> Error {
    match error.kind() {
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge => refusal(
            path,
            format!("there is no room left; make some, or write elsewhere ({error})"),
        ),
        _ => refusal(path, error.to_string()),
    }
}

fn refusal(path: &Path, reason: impl Into<String>) -> Error {
    Error::Write {
        path: path.to_owned(),
        reason: reason.into(),
    }
}

/// An empty file in the folder of `path`, which is deleted unless it gets that name.
fn temporary_file(path: &Path) -> Result<NamedTempFile, Error> {
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let shown = text::path(folder);
    if !folder.is_dir() {
        return Err(refusal(
            path,
            if folder.exists() {
                format!("{shown} is a file, not a folder")
            } else {
                format!("there is no folder {shown}; create it first")
            },
        ));
    }
    // A rename would only check the permissions of the folder.
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => return Err(refusal(path, "a folder has this name")),
        Ok(found) if !found.is_file() => {
            return Err(refusal(path, "it is a device or a pipe, not a file"));
        }
        Ok(found) if found.permissions().readonly() => {
            return Err(refusal(path, "the file of this name is read-only"));
        }
        _ => {}
    }
    #[cfg_attr(not(unix), expect(unused_mut, reason = "only Unix has permissions"))]
    let mut builder = tempfile::Builder::new();
    // Temporary files are private by default; a picture gets the usual permissions.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder).map_err(|error| {
        let reason = format!("no file can be made in {shown} ({})", error.kind());
        refusal(path, reason)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_that_cannot_be_written_are_refused_before() {
        let folder = tempfile::tempdir().unwrap();
        let [file, read_only] = ["file", "read-only"].map(|name| folder.path().join(name));
        fs::write(&file, "old").unwrap();
        fs::write(&read_only, "old").unwrap();
        let mut permissions = fs::metadata(&read_only).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&read_only, permissions).unwrap();
        for (path, reason) in [
            (folder.path(), "a folder has this name"),
            (&folder.path().join("missing/a.png"), "create it first"),
            (&file.join("a.png"), "is a file, not a folder"),
            (&read_only, "is read-only"),
            #[cfg(unix)]
            (Path::new("/dev/null"), "a device or a pipe, not a file"),
            // Not even the superuser can make a file in /proc.
            #[cfg(target_os = "linux")]
            (Path::new("/proc/a"), "no file can be made in /proc ("),
        ] {
            let error = check_writable(path).unwrap_err().to_string();
            assert!(error.contains(reason), "{error}");
            assert_eq!(write(path, b"new").unwrap_err().to_string(), error);
        }
        check_writable(&folder.path().join("a.png")).unwrap();
        check_writable(&file).unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"old");
        write(&file, b"new").unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"new");
        assert_eq!(folder.path().read_dir().unwrap().count(), 2);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_and_a_file_keeps_its_permissions() {
        use std::os::unix::fs::{PermissionsExt, symlink};

        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("real")).unwrap();
        symlink("real/new", at("to-new")).unwrap();
        symlink("to-new", at("to-link")).unwrap();
        for text in ["first", "second"] {
            write(&at("to-link"), text.as_bytes()).unwrap();
            assert_eq!(fs::read_to_string(at("real/new")).unwrap(), text);
            assert!(at("to-link").is_symlink() && at("to-new").is_symlink());
        }
        for mode in [0o600, 0o666] {
            fs::set_permissions(at("real/new"), fs::Permissions::from_mode(mode)).unwrap();
            write(&at("to-new"), b"third").unwrap();
            let kept = fs::metadata(at("real/new")).unwrap().permissions().mode();
            assert_eq!(kept & 0o777, mode);
        }
    }
}
