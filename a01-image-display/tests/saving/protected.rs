//! Folders and files that may not be changed.

use std::fs;
use std::os::unix::fs::MetadataExt;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::Command;

use crate::{allow, assert_refused, folder, names, program, skip};

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
fn a_folder_that_may_not_be_changed_is_named() {
    let folder = folder();
    let saved = folder.path().join("saved.png");
    fs::write(&saved, "old").unwrap();
    allow(&saved, 0o666);
    allow(folder.path(), 0o555);
    for (line, sentence) in [
        ("render painter -o saved.png", "cannot write saved.png"),
        ("render painter -o new.png", "cannot write new.png"),
        ("render painter", "cannot write out"),
        (
            "report --quick -o .",
            "cannot write ./a01-image-display-save-diagonal.csv",
        ),
    ] {
        let Some(mut program) = as_user(folder.path(), line) else {
            break;
        };
        let reason = "no file can be made in . (permission denied)";
        assert_refused(&mut program, &format!("error: {sentence}: {reason}"));
    }
    allow(folder.path(), 0o755);
    assert_eq!(names(folder.path()), ["saved.png"]);
    assert!(fs::read(saved).unwrap() == b"old");
}

#[test]
fn a_file_that_may_not_be_changed_is_kept() {
    let folder = folder();
    let saved = folder.path().join("saved.png");
    fs::write(&saved, "old").unwrap();
    allow(&saved, 0o444);
    allow(folder.path(), 0o777);
    let line = "render painter -o saved.png";
    let Some(mut program) = as_user(folder.path(), line) else {
        return;
    };
    let reason = "the file of this name may not be changed; choose another";
    assert_refused(
        &mut program,
        &format!("error: cannot write saved.png: {reason}"),
    );
    assert_eq!(names(folder.path()), ["saved.png"]);
    assert!(fs::read(saved).unwrap() == b"old");
}
