//! The pictures of students' code, compared with recorded ones.

use std::path::Path;

use common::difference::{compare_with_file, largest, leave_pictures};
use common::{Image, picture_file};

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
