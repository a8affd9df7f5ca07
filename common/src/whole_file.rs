//! Writing files so that they are whole or absent.

use std::fs::{self, OpenOptions};
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::time::Duration;

use tempfile::NamedTempFile;

use crate::Error;

/// How files begin and end that have not yet got their name.
const PASSING: [&str; 2] = [".saving-", ".part"];

/// No file goes without its name as long as this; what does was left behind by
/// a program that was killed.
const LEFT_BEHIND: Duration = Duration::from_hours(1);

/// Writes a file of this name, instead of one that may be there.
///
/// It is written under another name in the same folder and then renamed: whoever
/// looks, and whenever the program is killed, finds the old file or the new one,
/// never half of it. If `path` is a symbolic link, it stays, and the file it
/// leads to is written.
pub fn write(path: &Path, content: impl Read) -> Result<(), Error> {
    let (file, end) = unnamed(path, content)?;
    let named = file.persist(end);
    named.map_err(|error| cannot_write(path, &error.error))?;
    Ok(())
}

/// Like [`write`], but false and without effect if there already is a file of
/// this name.
pub fn write_new(path: &Path, content: impl Read) -> Result<bool, Error> {
    let (file, end) = unnamed(path, content)?;
    match file.persist_noclobber(end) {
        Ok(_) => Ok(true),
        Err(error) if error.error.kind() == ErrorKind::AlreadyExists => Ok(false),
        Err(error) => Err(cannot_write(path, &error.error)),
    }
}

/// Says what would keep a file from being written, before there is anything to
/// write. Leaves nothing behind.
pub fn check_writable(path: &Path) -> Result<(), Error> {
    passing_file(path)?;
    Ok(())
}

/// The error that `path` cannot be written, with what would help.
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

/// A finished file that vanishes unless it is given the name that follows.
fn unnamed(path: &Path, mut content: impl Read) -> Result<(NamedTempFile, PathBuf), Error> {
    let (mut file, end) = passing_file(path)?;
    remove_left_behind(folder_of(&end));
    // Errors of the file itself do not tell its passing name.
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

/// An empty file that vanishes unless it is given the name that follows: `path`,
/// or what that leads to as a link.
fn passing_file(path: &Path) -> Result<(NamedTempFile, PathBuf), Error> {
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
    builder.prefix(PASSING[0]).suffix(PASSING[1]);
    // Temporary files are private by default, a picture need not be.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(folder).map_err(|error| {
        let reason = format!("no file can be made in {shown} ({})", error.kind());
        refusal(path, reason)
    })?;
    Ok((file, end))
}

/// Where a name leads. Renaming would replace the link, not the file behind it.
fn end_of_links(path: &Path) -> Result<PathBuf, Error> {
    let mut end = path.to_owned();
    // As many as Linux follows.
    for _ in 0..40 {
        match fs::read_link(&end) {
            Ok(next) => end = folder_of(&end).join(next),
            Err(_) => return Ok(end),
        }
    }
    Err(refusal(path, "it is a link that leads nowhere"))
}

/// Says what is wrong with replacing what has this name. Renaming would ask only
/// whether the folder may be changed.
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

/// Removes files from the folder that were never given their names.
fn remove_left_behind(folder: &Path) {
    let [begin, end] = PASSING;
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
pub fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs::File;
    use std::time::SystemTime;

    #[test]
    fn what_keeps_a_file_from_being_written_is_known_before() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        fs::write(&file, "").unwrap();
        for (path, reason) in [
            (folder.path().to_owned(), "a folder has this name"),
            (folder.path().join("missing/a.png"), "create it first"),
            (file.join("a.png"), "is a file, not a folder"),
        ] {
            let error = check_writable(&path).unwrap_err().to_string();
            assert!(error.ends_with(reason), "{error}");
            let same = write(&path, &b"new"[..]);
            assert_eq!(same.unwrap_err().to_string(), error);
        }
        check_writable(&folder.path().join("a.png")).unwrap();
        check_writable(&file).unwrap();
        assert_eq!(folder.path().read_dir().unwrap().count(), 1);
        assert_eq!(fs::read(&file).unwrap(), b"");
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_folder_that_takes_no_files_is_named() {
        // Not even the superuser can make a file in /proc.
        let error = check_writable(Path::new("/proc/a.png")).unwrap_err();
        let expected = "cannot write /proc/a.png: no file can be made in /proc (";
        assert!(error.to_string().starts_with(expected), "{error}");
    }

    #[test]
    fn content_that_breaks_off_leaves_the_old_file() {
        struct Broken;
        impl Read for Broken {
            fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
                Err(ErrorKind::StorageFull.into())
            }
        }
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        fs::write(&path, "old").unwrap();
        let error = write(&path, b"new".chain(Broken)).unwrap_err().to_string();
        assert!(error.contains("no room left; make some"), "{error}");
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(folder.path().read_dir().unwrap().count(), 1);
    }

    #[test]
    fn what_a_killed_program_left_is_removed_when_it_is_old() {
        let folder = tempfile::tempdir().unwrap();
        let left = |name: &str, age: u64| {
            let path = folder.path().join(name);
            let time = SystemTime::now() - Duration::from_secs(age);
            let file = File::create(&path).unwrap();
            file.set_modified(time).unwrap();
            path
        };
        let old = left(".saving-abc123.part", 3700);
        let kept = [
            left(".saving-def456.part", 3500),
            left(".saving-money", 9999),
            left("mine.part", 9999),
        ];
        write(&folder.path().join("a.csv"), &b"new"[..]).unwrap();
        assert!(!old.exists());
        assert!(kept.iter().all(|path| path.exists()));
    }

    #[test]
    fn what_would_help_is_told() {
        let reason = |kind: ErrorKind| {
            let error = cannot_write(Path::new("a"), &kind.into()).to_string();
            let reason = error.strip_prefix("cannot write a: ").unwrap();
            let (reason, _) = reason.split_once(" (").unwrap_or((reason, ""));
            reason.to_owned()
        };
        let no_room = "there is no room left; make some, or write elsewhere";
        assert_eq!(reason(ErrorKind::StorageFull), no_room);
        assert_eq!(reason(ErrorKind::QuotaExceeded), no_room);
        let too_large = "it is larger than a file may be there; write less, or elsewhere";
        assert_eq!(reason(ErrorKind::FileTooLarge), too_large);
        assert_eq!(reason(ErrorKind::BrokenPipe), "broken pipe");
    }

    #[test]
    fn a_name_alone_lies_in_the_current_folder() {
        assert_eq!(folder_of(Path::new("a.png")), Path::new("."));
        assert_eq!(folder_of(Path::new("out/a.png")), Path::new("out"));
    }

    #[cfg(unix)]
    mod links {
        use super::*;
        use std::os::unix::fs::symlink;

        #[test]
        fn a_link_stays_and_the_file_behind_it_is_written() {
            let folder = tempfile::tempdir().unwrap();
            let (here, there) = (folder.path().join("here"), folder.path().join("there"));
            fs::create_dir(&here).unwrap();
            fs::create_dir(&there).unwrap();
            symlink("second", here.join("first")).unwrap();
            symlink("../there/file", here.join("second")).unwrap();
            for content in ["one", "two"] {
                write(&here.join("first"), content.as_bytes()).unwrap();
                assert_eq!(fs::read(there.join("file")).unwrap(), content.as_bytes());
            }
            assert!(here.join("first").is_symlink() && here.join("second").is_symlink());
            assert!(!there.join("file").is_symlink());
            assert!(!write_new(&here.join("first"), &b"three"[..]).unwrap());
            assert_eq!(there.read_dir().unwrap().count(), 1);
        }

        #[test]
        fn links_that_lead_nowhere_are_told() {
            let folder = tempfile::tempdir().unwrap();
            let (circle, lost) = (folder.path().join("circle"), folder.path().join("lost"));
            symlink("circle", &circle).unwrap();
            symlink("missing/file", &lost).unwrap();
            let reason = |path: &Path| check_writable(path).unwrap_err().to_string();
            assert!(reason(&circle).ends_with("a link that leads nowhere"));
            assert!(reason(&lost).ends_with("missing; create it first"));
        }

        #[test]
        fn what_is_no_file_is_not_replaced() {
            let folder = tempfile::tempdir().unwrap();
            let link = folder.path().join("null.png");
            symlink("/dev/null", &link).unwrap();
            let error = write(&link, &b"new"[..]).unwrap_err().to_string();
            assert!(error.contains("a device or a pipe, not a file"), "{error}");
        }
    }
}
