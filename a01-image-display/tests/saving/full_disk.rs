//! No room for the file.

use std::fs;

use crate::tmpfs::Tmpfs;
use crate::{assert_refused, assert_success, folder, in_shell, program, skip, write_noise};

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
    // Pictures are encoded in memory up to 16 MiB, and beside the file above.
    for side in [2500, 300] {
        let noise = folder.path().join(format!("{side}.png"));
        write_noise(&noise, side, 1);
        let line = format!("render show-image -o saved.png --open {}", noise.display());
        let sentence = format!("error: cannot write saved.png: {NO_ROOM}");
        assert_refused(disk.path(), &mut program(disk.path(), &line), &sentence);
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
    let mut program = program(disk.path(), "report save-diagonal --quick -o .");
    let sentence = format!("error: cannot write ./{table}: {NO_ROOM}");
    assert_refused(disk.path(), &mut program, &sentence);
}

/// Every user can limit the length of files.
#[test]
fn a_file_that_becomes_too_long_keeps_the_old_one() {
    let folder = folder();
    write_noise(&folder.path().join("noise.png"), 300, 1);
    fs::write(folder.path().join("saved.png"), "old").unwrap();
    let line = "render show-image --open noise.png -o saved.png";
    let script = "trap '' XFSZ; ulimit -f 64; exec \"$@\"";
    let mut limited = in_shell(script, &program(folder.path(), line));
    let sentence = "error: cannot write saved.png: it is larger than a file may be there; \
                    write less, or elsewhere (";
    assert_refused(folder.path(), &mut limited, sentence);
}
