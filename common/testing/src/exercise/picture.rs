//! The pictures of students' code: saved to be looked at, and compared with the book's.

use std::path::{Path, PathBuf};
use std::{env, fs};

use common::{Error, Image, Scene, Settings, Transfer, picture_file};

use common::difference::{compare_with_file, largest, leave_pictures};

/// The workspace.
pub(super) const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The folder for the pictures of exercises, as seen from the current one. If it cannot be
/// made, saving fails.
fn folder() -> PathBuf {
    let folder = Path::new(ROOT).join("out/exercises");
    let _ = fs::create_dir_all(&folder);
    let folder = folder.canonicalize().unwrap_or(folder);
    let here = env::current_dir().unwrap_or_default();
    folder
        .strip_prefix(here)
        .map_or(folder.clone(), Path::to_owned)
}

/// The picture of this name in the book.
pub fn in_book(name: &str) -> PathBuf {
    Path::new(ROOT).join("book/src/pictures").join(name)
}

/// Renders a scene by the lesson into a file of this name, and returns its path.
pub fn of_lesson(scene: &Scene, settings: &Settings, name: &str) -> Result<PathBuf, Error> {
    let (path, image) = (folder().join(name), scene.render(settings, &())?);
    picture_file::save_png(&path, image.size(), &image.to_rgb8(Transfer::Linear))?;
    Ok(path)
}

/// Saves a picture, and prints where it lies.
pub fn save(image: &Image, name: &str) {
    let path = folder().join(name);
    match picture_file::save_png(&path, image.size(), &image.to_rgb8(Transfer::Linear)) {
        Ok(()) => println!("picture: {}", path.display()),
        Err(error) => println!("a picture: {error}"),
    }
}

/// Compares a picture with the expected one in a file, and says whether its bytes are equal,
/// too: a picture is right if no channel differs by more than 1 of 255. The error describes
/// the difference, which is saved if somebody looks at it.
pub fn compare(expected: &Path, image: &Image, is_watched: bool) -> Result<String, String> {
    let Err(difference) = compare_with_file(expected, image) else {
        return Ok("the picture is the lesson's, bit for bit".to_owned());
    };
    let most = picture_file::open(expected).ok();
    let most = most.and_then(|expected| largest(&expected, image));
    if most.is_some_and(|(_, most)| most <= 1) {
        let (pixels, _) = difference.split_once(" differ").unwrap_or_default();
        return Ok(format!(
            "the picture is right; {pixels} differ by 1 of 255 from the lesson's bytes"
        ));
    }
    Err(if is_watched {
        leave_pictures(&folder(), expected, image, &difference)
    } else {
        difference
    })
}
