//! No room for the file.

use std::fs;

use crate::tmpfs::Tmpfs;
use crate::{assert_refused, assert_success, folder, in_shell, names, program, skip, write_noise};

const NO_ROOM: &str = "there is no room left; make some, or write elsewhere (";

#[test]
fn a_full_disk_keeps_the_old_picture() {
    let (folder, disk) = (folder(), folder());
    let tmpfs = match Tmpfs::mount(disk.path(), "size=64k") {
        Ok(tmpfs) => tmpfs,
        Err(reason) => return skip("a full disk", &reason),
    };
    let saved = disk.path().join("saved.png");
    write_noise(&saved, 9, 0);
    let old = fs::read(&saved).unwrap();
    // Pictures are encoded in memory up to 16 MiB, and beside the file above.
    for side in [300, 2500] {
        let noise = folder.path().join(format!("{side}.png"));
        write_noise(&noise, side, 1);
        let line = format!("render show-image -o saved.png --open {}", noise.display());
        let sentence = format!("error: cannot write saved.png: {NO_ROOM}");
        assert_refused(&mut program(disk.path(), &line), &sentence);
        assert_eq!(names(disk.path()), ["saved.png"], "{side}");
        assert!(fs::read(&saved).unwrap() == old, "{side}");
    }
    tmpfs.change("size=1m");
    let noise = folder.path().join("300.png");
    let line = format!("render show-image -o saved.png --open {}", noise.display());
    assert_success(&mut program(disk.path(), &line));
    assert!(fs::read(&saved).unwrap() == fs::read(&noise).unwrap());
}

#[test]
fn a_full_disk_keeps_the_old_report() {
    let disk = folder();
    let _tmpfs = match Tmpfs::mount(disk.path(), "size=8k") {
        Ok(tmpfs) => tmpfs,
        Err(reason) => return skip("a report on a full disk", &reason),
    };
    // A page for each.
    let table = "a01-image-display-save-diagonal.csv";
    fs::write(disk.path().join(table), "old").unwrap();
    fs::write(disk.path().join("other"), "full").unwrap();
    let line = "report save-diagonal --quick -o .";
    let sentence = format!("error: cannot write ./{table}: {NO_ROOM}");
    assert_refused(&mut program(disk.path(), line), &sentence);
    assert_eq!(names(disk.path()), [table, "other"]);
    assert!(fs::read(disk.path().join(table)).unwrap() == b"old");
}

/// Every user can try it: a limit for the length of files.
#[test]
fn a_file_that_becomes_too_long_keeps_the_old_one() {
    let folder = folder();
    let path = |name| folder.path().join(name);
    write_noise(&path("noise.png"), 300, 1);
    fs::write(path("saved.png"), "old").unwrap();
    let line = "render show-image --open noise.png -o saved.png";
    let script = "trap '' XFSZ; ulimit -f 64; exec \"$@\"";
    let sentence = "error: cannot write saved.png: it is larger than a file may be there; \
                    write less, or elsewhere (";
    assert_refused(
        &mut in_shell(script, &program(folder.path(), line)),
        sentence,
    );
    assert_eq!(names(folder.path()), ["noise.png", "saved.png"]);
    assert!(fs::read(path("saved.png")).unwrap() == b"old");
}
