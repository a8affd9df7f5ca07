//! The pictures of students' code, compared with recorded ones.

use std::path::{Path, PathBuf};

use common::difference::{compare_with_file, largest, leave_pictures};
use common::{Image, picture_file};

use crate::PictureVerdict;

/// The file with the expected picture of a stage's scene in a workbook: the book's, or, of a scene
/// with many samples, one with few that is recorded with the answers.
#[must_use]
pub fn expected_picture(workbook: &Path, stage: &str, scene: &str) -> PathBuf {
    let name = format!("{stage}-{scene}.png");
    let recorded = workbook.join(stage).join("exercises/answers").join(&name);
    if recorded.is_file() {
        return recorded;
    }
    workbook.join("book/src/pictures").join(name)
}

/// What the comparison of the picture of a scene says. With a folder, pictures that differ are
/// saved there.
#[must_use]
pub fn pictured(
    scene: &str,
    expected: &Path,
    image: &Image,
    folder: Option<&Path>,
) -> PictureVerdict {
    let compared = compare_picture(expected, image, folder);
    let is_right = compared.is_ok();
    let words = compared.unwrap_or_else(|wrong| wrong);
    PictureVerdict {
        name: format!("the picture of scene {scene}"),
        is_right,
        words,
        divergence: None,
    }
}

/// Compares a picture with the expected one in a file, and says whether its bytes are equal,
/// too: a picture is right if no channel differs by more than 1 of 255.
///
/// # Errors
///
/// The error describes the difference; with a folder, both pictures and their difference are
/// saved there.
pub fn compare_picture(
    expected: &Path,
    image: &Image,
    folder: Option<&Path>,
) -> Result<String, String> {
    let Err(difference) = compare_with_file(expected, image) else {
        return Ok("the picture is the lesson's, bit for bit".to_owned());
    };
    let expected_image = picture_file::open(expected).ok();
    let most = expected_image.and_then(|expected| largest(&expected, image));
    if most.is_some_and(|(_, most)| most <= 1) {
        let (pixels, _) = difference.split_once(" differ").unwrap_or_default();
        return Ok(format!(
            "the picture is right; {pixels} differ by 1 of 255 from the lesson's bytes"
        ));
    }
    Err(match folder {
        Some(folder) => leave_pictures(folder, expected, image, &difference),
        None => difference,
    })
}
