//! Arguments and files that are refused.

use std::fs;

use super::{PICTURES, assert_refused, folder, program, run, test_card};

#[test]
fn renderers_that_exclude_each_other_are_refused() {
    let folder = folder();
    let both = "render painter --fast --no-omit";
    assert_refused(&folder, both, 2, "cannot be used with");
    let alone = "render painter --explain --no-omit";
    assert_refused(&folder, alone, 2, "give --explain without --no-omit");
}

#[test]
fn an_output_that_cannot_be_meant_is_refused() {
    let folder = folder();
    let wanted = "must be a folder or the name of a PNG file";
    assert_refused(&folder, "render diagonal -o name.jpg", 2, wanted);
    let line = "render --all -o one.png";
    assert_refused(&folder, line, 2, "one picture, not 3; give a folder");
}

/// The picture to open is missing, too, which only the rendering would notice.
#[test]
fn an_unwritable_output_is_refused_before_the_rendering() {
    let folder = folder();
    fs::write(folder.path().join("file"), "").unwrap();
    let lost = "render show-image --open nowhere.png";
    let line = format!("{lost} -o missing/a.png");
    assert_refused(&folder, &line, 1, "no folder missing; create it first");
    let line = format!("{lost} -o missing/folder");
    assert_refused(&folder, &line, 1, "no folder missing; create it first");
    let line = format!("{lost} -o file/a.png");
    assert_refused(&folder, &line, 1, "file is a file, not a folder");

    fs::write(folder.path().join("out"), "").unwrap();
    assert_refused(&folder, lost, 1, "out is a file, not a folder");

    fs::create_dir_all(folder.path().join("there").join(PICTURES[2])).unwrap();
    let line = format!("{lost} -o there");
    assert_refused(&folder, &line, 1, "a folder has this name");
}

#[test]
#[cfg(target_os = "linux")]
fn a_folder_that_takes_no_files_is_named() {
    let folder = folder();
    let line = "render show-image --open nowhere.png -o /proc";
    assert_refused(&folder, line, 1, "no file can be made in /proc");
    for line in ["render diagonal", "show diagonal"] {
        let output = program(&folder, line).current_dir("/proc").output();
        let output = output.expect("the program runs");
        let complaint = String::from_utf8_lossy(&output.stderr);
        let sentence = "cannot write out: no file can be made in . (";
        assert!(complaint.contains(sentence), "{complaint}");
        assert_eq!(output.status.code(), Some(1));
    }
}

#[test]
fn a_scene_that_is_not_there_is_answered_with_those_that_are() {
    let folder = folder();
    let names = "no scene \"cube\"; it has diagonal, painter, show-image";
    for line in ["show cube", "render diagonal cube"] {
        assert_refused(&folder, line, 2, names);
    }
    for line in ["show", "render"] {
        assert_refused(&folder, line, 2, "<SCENE");
    }
}

#[test]
fn values_out_of_range_are_answered_with_the_range() {
    let folder = folder();
    for (line, sentence) in [
        ("--size 0x0", "from 1 to 32768 pixels a side"),
        ("--size 99999x99999", "from 1 to 32768 pixels a side"),
        ("--size 16384x16384", "at most 8192x8192 in all"),
        ("--size abc", "WIDTHxHEIGHT, such as 640x480"),
        ("--depth 0", "1.."),
        ("--samples 0", "1..=1000000"),
        ("--threads 0", "1..=1024"),
        ("--samples 5", "4 and 9 do"),
        ("--max-error 0", "above 0 and at most 1"),
        ("--max-error 3/2", "above 0 and at most 1"),
        ("--max-error 1/510 --sampling random", "cannot be used with"),
        ("--transfer loud", "linear, gamma, srgb"),
    ] {
        for command in ["render painter", "show painter", ""] {
            assert_refused(&folder, &format!("{command} {line}"), 2, sentence);
        }
    }
}

#[test]
fn pictures_that_cannot_be_opened_leave_no_file() {
    let folder = folder();
    let card = test_card();
    let file = |name: &str| folder.path().join(name);
    fs::write(file("half.png"), &card[..card.len() / 2]).unwrap();
    fs::write(
        file("corrupt.png"),
        [&card[..200], b"?", &card[201..]].concat(),
    )
    .unwrap();
    fs::write(file("old.png"), &card).unwrap();
    for (name, reason) in [
        ("missing.png", "there is no such file"),
        ("half.png", "the file ends too early"),
        ("corrupt.png", "the file is damaged"),
    ] {
        let sentence = format!("cannot open {name}: {reason}");
        for command in [
            "render show-image",
            "render show-image -o old.png",
            "show show-image",
        ] {
            let line = format!("{command} --open {name}");
            assert_refused(&folder, &line, 1, &sentence);
            // Not even a window is missed.
            let (_, _, complaint) = run(&folder, &line);
            assert!(complaint.starts_with("error: "), "{complaint}");
        }
    }
    assert_eq!(fs::read(file("old.png")).unwrap(), card);
}
