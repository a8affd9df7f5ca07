//! Folders and files that may not be changed.

use std::fs;
use std::io::Write;
use std::os::unix::fs::MetadataExt;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::Command;

use crate::{allow, assert_refused, folder, program};

/// The program run by an ordinary user, because permissions do not stop the superuser.
/// None if that user cannot start it, and a sentence on stderr.
fn as_user(folder: &Path, line: &str) -> Option<Command> {
    let mut command = program(folder, line);
    if fs::metadata(folder).unwrap().uid() == 0 {
        command.uid(65534).gid(65534);
        if let Err(error) = command.output() {
            let _ = writeln!(std::io::stderr(), "not tested as another user: {error}");
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
    let assert_named = |line, path, reason| {
        if let Some(mut program) = as_user(folder.path(), line) {
            let sentence = format!("error: cannot write {path}: {reason}");
            assert_refused(folder.path(), &mut program, &sentence);
        }
    };
    allow(&saved, 0o666);
    allow(folder.path(), 0o555);
    for (line, path) in [
        ("render painter -o saved.png", "saved.png"),
        ("render painter -o new.png", "new.png"),
        ("render painter", "out"),
        (
            "report --quick -o .",
            "./a01-image-display-save-diagonal.csv",
        ),
    ] {
        assert_named(line, path, "no file can be made in . (permission denied)");
    }
    allow(&saved, 0o444);
    allow(folder.path(), 0o777);
    let reason = "the file of this name may not be changed; choose another";
    assert_named("render painter -o saved.png", "saved.png", reason);
    allow(folder.path(), 0o755);
}
