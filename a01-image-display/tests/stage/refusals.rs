//! Arguments and files that are refused.

use std::fs;
#[cfg(unix)]
use std::process::Command;

use tempfile::TempDir;

use super::{files, folder, program, run, test_card};

/// The program must end with this code and one sentence that holds `sentence`,
/// say nothing else, and leave the files as they were.
fn assert_refused(folder: &TempDir, line: &str, code: i32, sentence: &str) {
    let before = files(folder.path());
    let (ended, said, complaint) = run(program(folder, line));
    assert!(complaint.contains(sentence), "{line}: {complaint}");
    assert_eq!(complaint.matches("error: ").count(), 1, "{complaint}");
    assert_eq!((ended, &*said), (Some(code), ""), "{line}: {complaint}");
    assert_eq!(files(folder.path()), before, "{line}");
}

/// The picture to open is missing, too, but only the rendering notices that.
#[test]
fn an_unwritable_output_is_refused_before_the_rendering() {
    let folder = folder();
    for file in ["file", "out"] {
        fs::write(folder.path().join(file), "").unwrap();
    }
    fs::create_dir_all(folder.path().join("there/a01-image-display-show-image.png")).unwrap();
    for (output, sentence) in [
        ("-o missing/a.png", "no folder missing; create it first"),
        ("-o missing/folder", "no folder missing; create it first"),
        ("-o file/a.png", "file is a file, not a folder"),
        ("", "out is a file, not a folder"),
        ("-o there", "a folder has this name"),
    ] {
        let line = format!("render show-image --open nowhere.png {output}");
        assert_refused(&folder, &line, 1, sentence);
    }
}

#[test]
fn wrong_arguments_are_refused_with_the_right_ones() {
    let folder = folder();
    let scenes = "no scene \"cube\"; it has diagonal, painter, show-image";
    let folder_or_file = "must be a folder or the name of a PNG file";
    for (line, sentence) in [
        ("show cube", scenes),
        ("render diagonal cube", scenes),
        ("show", "<SCENE"),
        ("render", "<SCENE"),
        ("render painter --fast --no-omit", "cannot be used with"),
        ("render painter --explain --no-omit", "cannot be used with"),
        ("render diagonal -o name.jpg", folder_or_file),
        ("render diagonal -o -", folder_or_file),
        (
            "render --all -o one.png",
            "one picture, not 3; give a folder",
        ),
    ] {
        assert_refused(&folder, line, 2, sentence);
    }
    for (flags, sentence) in [
        ("--size 0x0", "from 1 to 32768 pixels a side"),
        ("--size 16384x16384", "at most 8192x8192 in all"),
        ("--size abc", "WIDTHxHEIGHT, such as 640x480"),
        ("--depth 0", "from 1 to 10000"),
        ("--samples 0", "from 1 to 1000000"),
        ("--samples 1e9", "from 1 to 1000000"),
        ("--seed -1", "from 0 to 18446744073709551615"),
        ("--size -1x5", "WIDTHxHEIGHT, such as 640x480"),
        ("--threads 0", "from 1 to 1024"),
        ("--samples 5", "4 and 9 do"),
        ("--samples 4 --sampling center", "one center, not 4"),
        ("--max-error 0", "above 0 and at most 1"),
        ("--max-error 1/510 --sampling random", "cannot be used with"),
        ("--sampling loud", "center, regular, random, stratified"),
        ("--transfer loud", "linear, gamma, srgb"),
    ] {
        for command in ["render painter", "show painter", ""] {
            assert_refused(&folder, &format!("{command} {flags}"), 2, sentence);
        }
    }
}

#[test]
fn pictures_that_cannot_be_opened_leave_no_file() {
    let folder = folder();
    let card = test_card();
    for (name, bytes) in [
        ("half.png", &card[..card.len() / 2]),
        ("corrupt.png", &[&card[..200], b"?", &card[201..]].concat()),
        ("old.png", &card),
    ] {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    for (name, reason) in [
        ("missing.png", "there is no such file"),
        ("half.png", "the file ends too early"),
        ("corrupt.png", "its decoder refuses it ("),
    ] {
        // `show` reports this and not a missing display.
        let sentence = format!("error: cannot open {name}: {reason}");
        for command in [
            "render show-image",
            "render -o old.png show-image",
            "show show-image",
        ] {
            assert_refused(&folder, &format!("{command} --open {name}"), 1, &sentence);
        }
    }
    assert_eq!(fs::read(folder.path().join("old.png")).unwrap(), card);
}

/// Every user can limit the length of files.
#[test]
#[cfg(unix)]
fn a_picture_without_room_keeps_the_old_one() {
    let folder = folder();
    let old = folder.path().join("old.png");
    fs::write(&old, "old").unwrap();
    let render = program(&folder, "render painter -o old.png");
    let mut limited = Command::new("sh");
    let script = "ulimit -f 0; exec \"$@\"";
    limited.args(["-c", script, "sh"]).arg(render.get_program());
    limited.args(render.get_args()).current_dir(&folder);
    let (code, _, complaint) = run(limited);
    let sentence = "error: cannot write old.png: there is no room left; make some";
    assert!(complaint.starts_with(sentence), "{complaint}");
    assert_eq!(
        (code, files(folder.path())),
        (Some(1), vec!["old.png".to_owned()])
    );
    assert_eq!(fs::read(old).unwrap(), b"old");
}

/// A terminal obeys control characters: these would clear it, and write over the line.
#[test]
fn control_characters_of_arguments_are_seen_instead_of_obeyed() {
    let folder = folder();
    let name = "a\u{1B}[2J\rb\u{202E}c";
    let (flag, folder_of_name) = (format!("--{name}"), format!("{name}/a.png"));
    for arguments in [
        &[name][..],
        &[&flag],
        &["show", name],
        &["render", name],
        &["render", "painter", &flag],
        &["render", "painter", "--samples", name],
        &["render", "painter", "--size", name],
        &["render", "painter", "--sampling", name],
        &["render", "painter", "-o", &folder_of_name],
        &["render", "show-image", "--open", name],
    ] {
        let mut program = program(&folder, "");
        program.args(arguments);
        let (code, said, complaint) = run(program);
        assert!(matches!(code, Some(1 | 2)), "{arguments:?}: {code:?}");
        assert_eq!(said, "");
        let is_obeyed =
            |letter: char| letter != '\n' && letter.is_control() || letter == '\u{202E}';
        assert!(!complaint.contains(is_obeyed), "{complaint:?}");
        assert!(complaint.contains(r"\rb\u{202e}c"), "{complaint}");
    }
}
