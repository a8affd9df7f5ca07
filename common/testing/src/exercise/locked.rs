//! Compares the picture that a student's code renders with the lock of its scene.

use std::fs;
use std::path::{Path, PathBuf};

use common::{Error, Image, Settings, Transfer, picture_file};
use measure::Stage;
use program::picture_name;

use crate::picture_lock::{compare_with_file, hash, leave_pictures};

/// The workspace.
const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The folder for the pictures of exercises, if it can be made.
pub fn folder() -> Option<PathBuf> {
    let folder = Path::new(ROOT).join("out/exercises");
    fs::create_dir_all(&folder).ok()?;
    folder.canonicalize().ok()
}

/// The picture of this name in the book.
pub fn in_book(name: &str) -> PathBuf {
    Path::new(ROOT).join("book/src/pictures").join(name)
}

/// Renders a scene, saves the picture as `left`, and compares its hash with the locked
/// one. If they differ, the error describes the difference, which is saved beside the
/// picture.
pub fn compare(
    stage: &Stage,
    name: &str,
    render: impl FnOnce(&Settings) -> Result<Image, Error>,
    left: Option<PathBuf>,
) -> Result<(), String> {
    let scene = stage.scene(name).map_err(|error| error.to_string())?;
    let image = render(&scene.defaults).map_err(|error| format!("scene {name}: {error}"))?;
    let rgb = image.to_rgb8(Transfer::Linear);
    if let Some(path) = &left {
        picture_file::save_png(path, image.size(), &rgb).map_err(|error| error.to_string())?;
        println!("picture: {}", path.display());
    }
    let lock = Path::new(ROOT).join(format!("{}/tests/snapshots/{name}.snap", stage.name));
    let lock = fs::read_to_string(&lock).map_err(|e| format!("{}: {e}", lock.display()))?;
    if lock.contains(&hash(&rgb)) {
        return Ok(());
    }
    let expected = in_book(&picture_name(stage, scene));
    let difference = compare_with_file(&expected, &image)
        .err()
        .unwrap_or_else(|| "its bytes are the book's, but its hash is not the lock's".to_owned());
    let difference = format!("the picture of scene {name}: {difference}");
    Err(match left.and_then(|_| folder()) {
        Some(folder) => leave_pictures(&folder, &expected, &image, &difference),
        None => difference,
    })
}
