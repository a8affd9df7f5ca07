//! The lines that the program prints, and the pictures that it writes.

use std::fs;
use std::process::Stdio;

use common::{Color, Image, picture_file};

use super::{ALWAYS_A_DISPLAY, files, folder, program, run, test_card};

/// Runs the program in a folder with a picture and another file. It must print the names and
/// sizes of these pictures, here without the name of the stage, and write no other file; and
/// its messages must begin like this, with no more lines.
fn written(line: &str, pictures: &str, notes: &str) -> Vec<Image> {
    let folder = folder();
    fs::write(folder.path().join("card.jpg"), test_card()).unwrap();
    fs::write(folder.path().join("mine.PNG"), "old").unwrap();
    let (code, said, complaint) = run(program(&folder, line));
    assert_eq!(code, Some(0), "{complaint}");
    assert!(complaint.starts_with(notes), "{line}: {complaint}");
    assert_eq!(complaint.lines().count(), notes.lines().count());
    let short = |name: &str| name.replace("a01-image-display-", "").replace('\\', "/");
    let (mut printed, mut images) = (Vec::new(), Vec::new());
    for line in said.lines() {
        let mut words = line.split("  ");
        let [name, size] = [(); 2].map(|()| words.next().expect(line));
        let image = picture_file::open(&folder.path().join(name)).expect("a whole picture");
        assert_eq!(image.size().to_string(), size);
        printed.push(format!("{} {size}", short(name)));
        images.push(image);
    }
    assert_eq!(printed.join(", "), pictures, "{line}");
    let mut left = files(folder.path());
    left.retain(|name| !name.ends_with('/') && !pictures.contains(&short(name)));
    let is_mine = |name: &String| name == "card.jpg" || name == "mine.PNG";
    assert!(left.iter().all(is_mine), "{left:?}");
    images
}

#[test]
fn list_names_every_scene_on_a_line() {
    let folder = folder();
    let (code, said, complaint) = run(program(&folder, "list"));
    let names = said.lines().map(|line| line.split("  ").next().unwrap());
    assert!(names.eq(["diagonal", "painter", "show-image"]), "{said}");
    assert_eq!((code, complaint.as_str()), (Some(0), ""));
    assert!(files(folder.path()).is_empty());
}

#[test]
fn pictures_go_to_a_folder_or_to_the_file_that_is_named() {
    let all = "out/diagonal.png 32x24, out/painter.png 32x24, out/show-image.png 640x480";
    let note = "note: --size changes nothing in show-image\n";
    written("render --all --size 32x24", all, note);
    let two = "there/painter.png 8x6, there/diagonal.png 8x6";
    let twice = "render painter diagonal painter --size 8x6 -o there";
    written(twice, two, "");
    let replaced = written("render painter --size 1x1 -o mine.PNG", "mine.PNG 1x1", "");
    assert_eq!(replaced[0].pixels(), [Color::RED]);
    let card = written("render show-image -o a.png", "a.png 640x480", "");
    let opened = "render show-image --open card.jpg -o a.png";
    assert_eq!(written(opened, "a.png 640x480", ""), card);
}

#[test]
fn without_a_window_the_picture_lands_in_a_file() {
    let reason = match (ALWAYS_A_DISPLAY, cfg!(feature = "window")) {
        (true, _) => "",
        (false, true) => "no window: no display to open it on (",
        (false, false) => "no window: this build has none",
    };
    written("show painter --size 8x6", "out/painter.png 8x6", reason);
    for line in ["--no-window", "show diagonal --no-window"] {
        written(&format!("{line} --size 8x6"), "out/diagonal.png 8x6", "");
    }
    let hint = "note: this is the picture of the program; --open FILE shows one";
    written(
        "show show-image --no-window",
        "out/show-image.png 640x480",
        hint,
    );
}

/// A pipe whose other end is closed already.
fn closed() -> Stdio {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    writer.into()
}

#[test]
fn a_closed_pipe_is_no_error() {
    let folder = folder();
    for line in ["list", "--help", "render diagonal"] {
        let output = program(&folder, line).stdout(closed()).output().unwrap();
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{line}");
        assert_eq!(output.status.code(), Some(0), "{line}");
    }
    for (line, code) in [
        ("show cube", 2),
        ("--size 0x0", 2),
        ("render show-image --open missing.png", 1),
        ("render diagonal --depth 3", 0),
        ("show diagonal", 0),
    ] {
        let mut program = program(&folder, line);
        let status = program.stdout(closed()).stderr(closed()).status();
        assert_eq!(status.unwrap().code(), Some(code), "{line}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_device_is_an_error() {
    let folder = folder();
    for line in ["list", "--help", "render diagonal"] {
        let full = fs::File::options().write(true).open("/dev/full").unwrap();
        let output = program(&folder, line).stdout(full).output().unwrap();
        let complaint = String::from_utf8(output.stderr).unwrap();
        let sentence = "error: cannot write standard output: there is no room left";
        assert!(complaint.starts_with(sentence), "{line}: {complaint}");
        assert_eq!(output.status.code(), Some(1), "{line}");
    }
}
