//! Files that cannot be written or opened: a message, and nothing is lost.

use std::fs;

use super::{
    close, locked_file, wait_for_painter_in, wait_for_picture, wait_for_text, with_window,
};

#[test]
fn an_error_while_saving_is_shown_and_saving_can_be_repeated() {
    with_window("show painter", |window, folder| {
        wait_for_picture(&window, "painter");
        let out = folder.join("out");
        fs::write(&out, "a letter").unwrap();
        window.press("s");
        let name = "out/a01-image-display-painter.png";
        let error = format!("error: cannot write {name}: out is a file, not a folder");
        wait_for_text(&window, &error);
        assert_eq!(fs::read_to_string(&out).unwrap(), "a letter");

        fs::remove_file(&out).unwrap();
        window.press("s");
        wait_for_painter_in(folder);
        close(window);
    });
}

#[test]
fn a_bad_file_is_named_while_its_scene_is_shown() {
    with_window("show diagonal --open half.png", |window, folder| {
        let card = fs::read(locked_file("show-image")).unwrap();
        fs::write(folder.join("half.png"), &card[..card.len() / 2]).unwrap();
        window.press("Left");
        let error =
            "error: cannot open half.png: the file ends too early; it may be only half copied";
        wait_for_text(&window, error);
        window.press("s");
        wait_for_text(
            &window,
            &format!("{error}\", \"there is no picture to save"),
        );
        wait_for_text(&window, error);
        window.press("Left");
        wait_for_picture(&window, "painter");
        assert!(!folder.join("out").exists());
    });
}

#[test]
fn without_a_file_dialog_the_test_card_is_shown_with_a_hint() {
    let hint = "no file was chosen; the argument --open FILE shows one, too";
    with_window("show show-image", |window, _| {
        wait_for_text(&window, hint);
        wait_for_picture(&window, "show-image");
        window.press("ctrl+o");
        wait_for_text(&window, hint);
        close(window);
    });
}
