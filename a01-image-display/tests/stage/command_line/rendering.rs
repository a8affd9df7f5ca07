//! The scenes that are listed and rendered, and the files that they go to.

use std::fs;
use std::path::Path;

use common::{Color, Size};

use super::{PICTURES, folder, left, open, run, test_card};

#[test]
fn list_names_every_scene_on_a_line() {
    let folder = folder();
    let (code, said, complaint) = run(&folder, "list");
    let names = said.lines().map(|line| line.split("  ").next().unwrap());
    assert!(names.eq(["diagonal", "painter", "show-image"]), "{said}");
    assert_eq!((code, complaint.as_str()), (0, ""));
    assert!(left(&folder).is_empty());
}

#[test]
fn render_all_fills_the_folder_out_and_says_where() {
    let folder = folder();
    let (code, said, complaint) = run(&folder, "render --all --size 32x24");
    assert_eq!(code, 0, "{complaint}");
    let note = "note: --size changes nothing in show-image\n";
    assert_eq!(complaint, note);
    let paths = PICTURES.map(|name| Path::new("out").join(name));
    assert_eq!(said.lines().count(), 3, "{said}");
    for (line, path) in said.lines().zip(&paths) {
        assert!(line.starts_with(path.to_str().unwrap()), "{line}");
    }
    let files = PICTURES.map(|name| format!("out/{name}"));
    assert_eq!(left(&folder)[1..], files);
    let sizes = files.map(|name| open(&folder, &name).size().to_string());
    assert_eq!(sizes, ["32x24", "32x24", "640x480"]);
}

#[test]
fn one_scene_goes_to_the_file_that_is_named_and_replaces_it() {
    let folder = folder();
    fs::write(folder.path().join("mine.PNG"), "old").unwrap();
    let (code, said, _) = run(&folder, "render painter --size 1x1 -o mine.PNG");
    assert_eq!(code, 0);
    assert!(said.starts_with("mine.PNG  1x1"), "{said}");
    assert_eq!(left(&folder), ["mine.PNG"]);
    assert_eq!(open(&folder, "mine.PNG").pixels(), [Color::RED]);
}

#[test]
fn several_scenes_go_to_a_folder_which_is_made() {
    let folder = folder();
    let (code, _, complaint) = run(&folder, "render painter diagonal -o there");
    assert_eq!((code, complaint.as_str()), (0, ""));
    let expected = PICTURES[..2].iter().map(|name| format!("there/{name}"));
    assert!(left(&folder).into_iter().skip(1).eq(expected));
}

#[test]
fn a_picture_that_opens_is_written_as_it_is() {
    let folder = folder();
    fs::write(folder.path().join("card.jpg"), test_card()).unwrap();
    let line = "render show-image --open card.jpg -o copy.png";
    let (code, _, complaint) = run(&folder, line);
    assert_eq!((code, complaint.as_str()), (0, ""));
    assert_eq!(open(&folder, "copy.png"), open(&folder, "card.jpg"));
    assert_eq!(open(&folder, "copy.png").size(), Size::COURSE);
}

#[test]
fn a_flag_that_changes_nothing_is_noted_and_changes_nothing() {
    let folder = folder();
    let (_, _, complaint) = run(&folder, "render diagonal --depth 3 --seed 1 -o a.png");
    let note = |flag| format!("note: {flag} changes nothing in diagonal\n");
    assert_eq!(complaint, note("--seed") + &note("--depth"));
    let (_, _, complaint) = run(
        &folder,
        "render diagonal --threads 1 --transfer srgb -o b.png",
    );
    assert_eq!(complaint, "");
    assert_eq!(open(&folder, "a.png"), open(&folder, "b.png"));
}
