//! Reads the files that a person names, whole: no pipe, which may wait for ever, and none that is
//! too long. A name that is not there gets the nearest one that is.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use crate::text;

/// The bytes of a file, whose name is relative to this folder, if it has at most as many. The
/// error is a clause.
pub fn read(folder: &Path, name: &Path, most: u64) -> Result<Vec<u8>, String> {
    if name.as_os_str().is_empty() {
        return Err("the name is empty".to_owned());
    }
    let path = folder.join(name);
    let found = fs::metadata(&path).map_err(|error| match error.kind() {
        ErrorKind::NotFound if path.is_symlink() => "it is a link to nothing".to_owned(),
        ErrorKind::NotFound => missing(folder, name),
        _ => error.to_string(),
    })?;
    if found.is_dir() {
        return Err("it is a folder".to_owned());
    }
    if !found.is_file() {
        return Err("it is a pipe or a device, not a file".to_owned());
    }
    if found.len() > most {
        return Err(format!("it has more than {most} bytes"));
    }
    fs::read(path).map_err(|error| error.to_string())
}

/// What is missing, and the nearest name that is there.
fn missing(folder: &Path, name: &Path) -> String {
    let path = folder.join(name);
    let absolute = std::path::absolute(&path).unwrap_or(path);
    let parent = absolute.parent().unwrap_or(&absolute);
    let shown = text::path(parent);
    let missing = if parent.is_dir() {
        format!("there is no such file in the folder {shown}")
    } else {
        format!("there is no folder {shown}")
    };
    match nearest(folder, name) {
        Some(nearest) => format!("{missing}; the nearest is {}", text::path(&nearest)),
        None => missing,
    }
}

/// The name that is there and most like this one, part by part, which may begin as the name of a
/// home folder or as the address of a file.
fn nearest(folder: &Path, name: &Path) -> Option<PathBuf> {
    let name = name.to_string_lossy();
    let address = name.strip_prefix("file://");
    let name = address.map_or(name.to_string(), |path| path.replace("%20", " "));
    let at_home = name.strip_prefix("~/").zip(std::env::home_dir());
    let name = at_home.map_or(PathBuf::from(&name), |(rest, home)| home.join(rest));
    let mut found = PathBuf::new();
    for part in name.components() {
        let place = Path::new(".").join(folder).join(&found);
        if place.join(part).exists() {
            found.push(part);
            continue;
        }
        let mut names = Vec::new();
        for entry in fs::read_dir(place).ok()?.flatten() {
            names.push(entry.file_name().to_string_lossy().into_owned());
        }
        let names: Vec<_> = names.iter().map(String::as_str).collect();
        let part = part.as_os_str().to_string_lossy();
        found.push(text::nearest(&names, &part)?);
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_and_anything_else_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        fs::create_dir(folder.join("models")).unwrap();
        fs::write(folder.join("models/tri.obj"), "f 1 2 3").unwrap();
        let read = |name: &str| read(folder, Path::new(name), 7);
        assert_eq!(read("models/tri.obj"), Ok(b"f 1 2 3".to_vec()));
        let address = format!("file://{}/models/tri.obj", folder.display());
        let in_models = "models; the nearest is models/tri.obj";
        for (name, begin, end) in [
            ("models", "it is a folder", ""),
            ("", "the name is empty", ""),
            (
                "Models/Tri.OBJ",
                "there is no folder ",
                "/Models; the nearest is models/tri.obj",
            ),
            (
                "models/tri.obj ",
                "there is no such file in the folder ",
                in_models,
            ),
            (&address, "there is no folder ", &address["file://".len()..]),
            (
                "knot.ply",
                "there is no such file in the folder ",
                &address[7..address.len() - 15],
            ),
        ] {
            let reason = read(name).unwrap_err();
            assert!(
                reason.starts_with(begin) && reason.ends_with(end),
                "{reason}"
            );
        }
        fs::write(folder.join("long"), "12345678").unwrap();
        assert_eq!(read("long"), Err("it has more than 7 bytes".to_owned()));
    }

    #[cfg(unix)]
    #[test]
    fn a_pipe_and_a_link_to_nothing_are_refused_at_once() {
        let folder = tempfile::tempdir().unwrap();
        std::os::unix::fs::symlink("gone", folder.path().join("link")).unwrap();
        let nothing = read(folder.path(), Path::new("link"), 9);
        assert_eq!(nothing, Err("it is a link to nothing".to_owned()));
        let pipe = folder.path().join("pipe");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.unwrap().success());
        let reason = "it is a pipe or a device, not a file";
        assert_eq!(
            read(folder.path(), Path::new("pipe"), 9),
            Err(reason.to_owned())
        );
    }
}
