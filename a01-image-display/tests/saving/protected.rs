//! Folders and files that may not be changed.

use std::fs;
use std::os::unix::fs::{MetadataExt, symlink};
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::Command;

use crate::tmpfs::Tmpfs;
use crate::{allow, assert_refused, assert_success, folder, names, program, skip};

/// The program run by an ordinary user, because permissions do not stop the superuser.
/// None if that user cannot start it.
fn as_user(folder: &Path, line: &str) -> Option<Command> {
    let mut command = program(folder, line);
    if fs::metadata(folder).unwrap().uid() == 0 {
        command.uid(65534).gid(65534);
        if let Err(error) = command.output() {
            skip("what other users may not write", &error.to_string());
            return None;
        }
    }
    Some(command)
}

#[test]
fn a_folder_that_may_not_be_changed_is_told() {
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

#[test]
fn a_picture_that_may_not_be_read_is_told_and_the_old_one_kept() {
    let folder = folder();
    let path = |name| folder.path().join(name);
    fs::write(path("secret.png"), "secret").unwrap();
    allow(&path("secret.png"), 0o000);
    fs::write(path("saved.png"), "old").unwrap();
    allow(&path("saved.png"), 0o666);
    allow(folder.path(), 0o777);
    let line = "render show-image --open secret.png -o saved.png";
    let Some(mut program) = as_user(folder.path(), line) else {
        return;
    };
    let sentence = "error: cannot open secret.png: Permission denied";
    assert_refused(&mut program, sentence);
    assert_eq!(names(folder.path()), ["saved.png", "secret.png"]);
    assert!(fs::read(path("saved.png")).unwrap() == b"old");
}

#[test]
fn a_disk_that_may_only_be_read_is_told() {
    let disk = folder();
    let tmpfs = match Tmpfs::mount(disk.path(), "size=64k") {
        Ok(tmpfs) => tmpfs,
        Err(reason) => return skip("a disk that may only be read", &reason),
    };
    fs::write(disk.path().join("saved.png"), "old").unwrap();
    tmpfs.change("ro");
    let sentence = "error: cannot write saved.png: no file can be made in . (read-only filesystem";
    let line = "render painter -o saved.png";
    assert_refused(&mut program(disk.path(), line), sentence);
    assert_eq!(names(disk.path()), ["saved.png"]);
    assert!(fs::read(disk.path().join("saved.png")).unwrap() == b"old");
}

#[test]
fn a_link_stays_and_the_file_behind_it_is_new() {
    let folder = folder();
    let path = |name| folder.path().join(name);
    fs::create_dir(path("there")).unwrap();
    fs::write(path("there/file"), "old").unwrap();
    symlink("there/file", path("link.png")).unwrap();
    let line = "render painter --size 8x8 -o link.png";
    assert_success(&mut program(folder.path(), line));
    assert!(path("link.png").is_symlink());
    assert!(
        fs::read(path("there/file"))
            .unwrap()
            .starts_with(b"\x89PNG")
    );
    assert_eq!(names(folder.path()), ["link.png", "there"]);
    assert_eq!(names(&path("there")), ["file"]);
}
