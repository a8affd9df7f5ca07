//! `save_beside_others`: saves a picture and overwrites no other.

use std::path::{Path, PathBuf};

use common::{Error, Size, Transfer, picture_file};

/// Saves a picture as `NAME.png`; beside a different picture of this name, with a number.
pub fn save_beside_others(
    folder: &Path,
    name: &str,
    size: Size,
    rgb: &[u8],
) -> Result<PathBuf, Error> {
    let is_same = |path: &Path| {
        picture_file::open(path)
            .is_ok_and(|other| other.size() == size && other.to_rgb8(Transfer::Linear) == rgb)
    };
    let mut path = folder.join(format!("{name}.png"));
    let mut number = 1;
    while path.exists() {
        if is_same(&path) {
            return Ok(path);
        }
        number += 1;
        path = folder.join(format!("{name}-{number}.png"));
    }
    picture_file::save_png(&path, size, rgb)?;
    Ok(path)
}

#[cfg(test)]
mod tests {
    use common::Color;

    use super::*;

    #[test]
    fn files_of_other_content_are_never_overwritten() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.png"), "a letter").unwrap();
        let size = Size::new(1, 1).unwrap();
        // The same picture is there already when it is saved again.
        for (gray, name) in [(2, "a-2.png"), (3, "a-3.png"), (2, "a-2.png")] {
            let path = save_beside_others(folder.path(), "a", size, &[gray; 3]).unwrap();
            assert_eq!(path.file_name().unwrap(), name);
            let saved = picture_file::open(&path).unwrap();
            assert_eq!(saved.pixels(), [Color::from_bytes([gray; 3])]);
        }
        let kept = std::fs::read_to_string(folder.path().join("a.png")).unwrap();
        assert_eq!(kept, "a letter");
        assert_eq!(folder.path().read_dir().unwrap().count(), 3);
    }
}
