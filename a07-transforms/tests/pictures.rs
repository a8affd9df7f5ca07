//! The locked pictures of this stage, and those that the book shows of scene files and of the dahlia.

use std::fs;

use a07_transforms::stage;
use testing::picture_lock::{BookPicture, check_book_pictures};

#[path = "../examples/dahlia.rs"]
#[expect(dead_code, reason = "the example's own main")]
mod example;

testing::lock_pictures! {
    stage();
    sphere_transformation box_transformations disc
}

#[test]
fn the_book_shows_what_scene_files_and_the_dahlia_draw() {
    let mut pictures = Vec::new();
    for scene in example::stage().scenes {
        let name = format!("{}.png", scene.name);
        pictures.push(BookPicture { name, scene });
    }
    let open = stage().open.unwrap();
    for file in fs::read_dir("scenes").unwrap() {
        let path = file.unwrap().path();
        if path.extension() == Some("toml".as_ref()) {
            let scene = open(&path).unwrap();
            let name = format!("scene-{}.png", scene.name);
            pictures.push(BookPicture { name, scene });
        }
    }
    check_book_pictures(&pictures, &TEST_PATHS);
}
