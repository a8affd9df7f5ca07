//! Files that cannot be written or opened: a message, and nothing is lost.

use std::fs;
use std::path::Path;

use testing::display::{Display, wait_for};

use super::tmpfs::Tmpfs;
use super::{
    file_name, folder, locked, locked_file, open, program, wait_for_notice, wait_for_picture,
};

#[test]
fn where_out_is_a_file_saving_says_so() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let out = folder.path().join("out");
    fs::write(&out, "a letter").unwrap();
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.press("s");
    let name = file_name("painter");
    let error = format!("error: cannot write out/{name}: out is a file, not a folder");
    wait_for_notice(&window, &error);
    assert_eq!(fs::read_to_string(&out).unwrap(), "a letter");

    fs::remove_file(&out).unwrap();
    window.press("s");
    wait_for("the file", || out.join(&name).exists().then_some(()));
    assert_eq!(open(&out.join(&name)), locked("painter"));
}

#[test]
fn where_no_file_can_be_made_saving_says_so() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let proc = Path::new("/proc");
    let mut window = display.start(&mut program(proc, "show painter"));
    wait_for_picture(&window, "painter");
    window.press("s");
    let start = "error: cannot write out: no file can be made in . (";
    window.wait_to_show(start, |look| look.notices().join(" ").starts_with(start));
    assert!(window.is_running());
}

#[test]
fn a_full_disk_is_told_and_half_a_file_is_not_left() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    // One page, which is less than the picture.
    let disk = match Tmpfs::mount(folder.path(), "size=4k") {
        Ok(disk) => disk,
        Err(reason) => {
            use std::io::Write;
            let _ = writeln!(
                std::io::stderr(),
                "no full disk is tested: {}",
                reason.trim()
            );
            return;
        }
    };
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.press("s");
    let name = file_name("painter");
    let start = format!("error: cannot write out/{name}: there is no room left; make some");
    window.wait_to_show(&start, |look| look.notices().join(" ").starts_with(&start));
    let out = folder.path().join("out");
    assert_eq!(out.read_dir().unwrap().count(), 0, "nothing is left");

    disk.change("size=1m");
    window.press("s");
    wait_for("the file", || out.join(&name).exists().then_some(()));
    assert_eq!(open(&out.join(&name)), locked("painter"));
    window.press("Escape");
    assert_eq!(window.wait_for_end().0, Some(0));
}

#[test]
fn a_different_picture_of_the_same_name_is_kept() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    let taken = out.join(file_name("painter"));
    fs::copy(locked_file("diagonal"), &taken).unwrap();
    let window = display.start(&mut program(folder.path(), "show painter"));
    wait_for_picture(&window, "painter");
    window.press("s s");
    wait_for_notice(&window, "saved out/a01-image-display-painter-2.png");
    assert_eq!(open(&taken), locked("diagonal"));
    let second = out.join("a01-image-display-painter-2.png");
    assert_eq!(open(&second), locked("painter"));
    window.press("Escape");
    assert_eq!(window.wait_for_end(), (Some(0), String::new()));
    assert_eq!(out.read_dir().unwrap().count(), 2);
}

#[test]
fn a_file_that_is_no_picture_is_told_for_as_long_as_its_scene_is_shown() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let card = fs::read(locked_file("show-image")).unwrap();
    fs::write(folder.path().join("half.png"), &card[..card.len() / 2]).unwrap();
    let line = "show diagonal --open half.png";
    let window = display.start(&mut program(folder.path(), line));
    wait_for_picture(&window, "diagonal");
    window.press("Left");
    let error = "error: cannot open half.png: the file ends too early; it may be only half copied";
    wait_for_notice(&window, error);
    window.press("s");
    wait_for_notice(&window, &format!("there is no picture to save {error}"));
    wait_for_notice(&window, error);
    assert!(!folder.path().join("out").exists());
    window.press("Left");
    wait_for_picture(&window, "painter");
}

#[test]
fn without_a_file_dialog_the_test_card_is_shown_and_how_to_name_a_file() {
    let Some(display) = Display::open(800, 600) else {
        return;
    };
    let folder = folder();
    let notice = "no file was chosen; the argument --open FILE shows one, too";
    let window = display.start(&mut program(folder.path(), "show show-image"));
    wait_for_notice(&window, notice);
    wait_for_picture(&window, "show-image");
    window.press("ctrl+o");
    wait_for_notice(&window, notice);
    window.press("Escape");
    assert_eq!(window.wait_for_end(), (Some(0), String::new()));
}
