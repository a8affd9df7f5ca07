//! Folders and files that may not be changed.

use std::fs;
use std::os::unix::fs::MetadataExt;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::Command;

use crate::{allow, assert_refused, folder, program, skip};

/// The program run by an ordinary user, because permissions do not stop the superuser.
/// None if that user cannot start it.
fn as_user(folder: &Path, line: &str) -> Option<Command> {
    let mut command = program(folder, line);
    if fs::metadata(folder).unwrap().uid() == 0 {
        command.uid(65534).gid(65534);
        if let Err(error) = command.output() {
            skip("files of another user", &error.to_string());
            return None;
        }
    }
    Some(command)
}

#[test]
fn a_folder_or_file_that_may_not_be_changed_is_named() {
    let folder = folder();
    let saved = folder.path().join("saved.png");
    fs::write(&saved, "old").unwrap();
    let no_file = "no file can be made in . (permission denied)";
    let no_change = "the file of this name may not be changed; choose another";
    let table = "./a01-image-display-save-diagonal.csv";
    for (file, mode, line, path, reason) in [
        (
            0o666,
            0o555,
            "render painter -o saved.png",
            "saved.png",
            no_file,
        ),
        (
            0o666,
            0o555,
            "render painter -o new.png",
            "new.png",
            no_file,
        ),
        (0o666, 0o555, "render painter", "out", no_file),
        (0o666, 0o555, "report --quick -o .", table, no_file),
        (
            0o444,
            0o777,
            "render painter -o saved.png",
            "saved.png",
            no_change,
        ),
    ] {
        allow(&saved, file);
        allow(folder.path(), mode);
        let Some(mut program) = as_user(folder.path(), line) else {
            break;
        };
        let sentence = format!("error: cannot write {path}: {reason}");
        assert_refused(folder.path(), &mut program, &sentence);
    }
    allow(folder.path(), 0o755);
}
