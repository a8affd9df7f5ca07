//! No room for the whole file: the program is refused more bytes, or killed.
//!
//! Every user can limit the length of files. One that becomes longer is an error, or the
//! end of the program, when exactly that many bytes are written.

use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::process::Command;

use crate::{assert_refused, folder, names, program, write_noise};

/// Runs a program after other commands of a shell, with this limit in blocks of 512 bytes.
fn limited(before: &str, blocks: u32, program: &Command) -> Command {
    let script = format!("{before}; ulimit -f {blocks}; exec \"$@\"");
    let mut shell = Command::new("sh");
    shell.args(["-c", &script, "sh"]).arg(program.get_program());
    shell.args(program.get_args());
    shell.current_dir(program.get_current_dir().expect("a folder"));
    shell
}

/// Pictures are encoded in memory up to 16 MiB, and larger ones in a file.
#[test]
fn a_file_that_becomes_too_long_keeps_the_old_one() {
    let folder = folder();
    let path = |name| folder.path().join(name);
    write_noise(&path("small.png"), 300, 1);
    write_noise(&path("large.png"), 2500, 1);
    let table = "./a01-image-display-save-diagonal.csv";
    fs::write(path("saved.png"), "old").unwrap();
    fs::write(path(table), "old").unwrap();
    let render = |file| format!("render show-image --open {file} -o saved.png");
    for (line, name, blocks) in [
        (render("small.png"), "saved.png", 64),
        (render("large.png"), "saved.png", 64),
        ("report save-diagonal --quick -o .".to_owned(), table, 0),
    ] {
        let mut limited = limited("trap '' XFSZ", blocks, &program(folder.path(), &line));
        let reason = "it is larger than a file may be there; write less, or elsewhere (";
        let sentence = format!("error: cannot write {name}: {reason}");
        assert_refused(folder.path(), &mut limited, &sentence);
    }
}

/// The unfinished file that it leaves is deleted by the next program, as the tests of
/// `common::atomic_file` show.
#[test]
fn a_killed_program_keeps_the_old_picture() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    write_noise(&path("noise.png"), 300, 1);
    fs::write(path("saved.png"), "old").unwrap();
    let line = "render show-image --open noise.png -o saved.png";
    for blocks in [0, 1, 64, 200, 500] {
        let mut killed = limited("ulimit -c 0", blocks, &program(folder.path(), line));
        let status = killed.output().unwrap().status;
        assert!(status.signal().is_some(), "{status}");
        assert!(fs::read(path("saved.png")).unwrap() == b"old", "{blocks}");
    }

    let is_unfinished = |name: &&String| name.starts_with(".saving-");
    let left = names(folder.path());
    let unfinished = left.iter().filter(is_unfinished).count();
    assert_eq!(unfinished + 2, left.len(), "{left:?}");
}
