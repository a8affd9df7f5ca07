//! `submission`: the files of exercises in a folder or a zip file. Nothing else is looked at.
//!
//! A file that calls the lesson instead of code of its own is refused by its words: a macro
//! can hide a call, and nothing finds the lesson's text in another file.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use zip::ZipArchive;

use crate::exercise::Exercise;

/// The most bytes of a student's file.
const MOST: u64 = 64 * 1024;

/// For each exercise, words that its code has only if it calls the lesson, and such words of all.
const LESSONS: &str = include_str!("../../handout/lessons.txt");

/// The text of a file, or why it is not judged.
pub fn read(submission: &Path, e: &Exercise) -> Result<String, String> {
    let path = format!("{}/exercises/{}.rs", e.stage, e.name);
    let read = if submission.is_dir() {
        from_folder(submission, &path)
    } else {
        from_zip(submission, &path)
    };
    match read {
        Ok(text) if text.len() as u64 > MOST => Err("the file is larger than 64 KiB".to_owned()),
        Ok(text) => refusal(e, &text).map_or(Ok(text), Err),
        Err(error) if error.kind() == ErrorKind::NotFound => Err("not handed in".to_owned()),
        Err(error) => Err(format!("the file cannot be read: {error}")),
    }
}

/// Reads a file, and follows no link out of the folder.
fn from_folder(folder: &Path, path: &str) -> io::Result<String> {
    let real = folder.join(path).canonicalize()?;
    if real != folder.canonicalize()?.join(path) || !real.is_file() {
        return Err(io::Error::other("it is a link, or no file"));
    }
    beginning(File::open(real)?)
}

/// Reads a file that is in a zip file, or in a folder there.
fn from_zip(archive: &Path, path: &str) -> io::Result<String> {
    let mut archive = ZipArchive::new(File::open(archive)?)?;
    let index = archive
        .file_names()
        .position(|name| name.is_ok_and(|name| Path::new(&*name).ends_with(path)));
    beginning(archive.by_index(index.ok_or(ErrorKind::NotFound)?)?)
}

fn beginning(file: impl Read) -> io::Result<String> {
    let mut text = String::new();
    file.take(MOST + 1).read_to_string(&mut text)?;
    Ok(text)
}

/// Why a file is not judged: it takes its answers from the lesson.
fn refusal(e: &Exercise, text: &str) -> Option<String> {
    let text: String = text.split_whitespace().collect();
    let text = text.replace("usecrate::prelude::*;", ";");
    let word = words("*")
        .chain(words(e.name))
        .find(|word| text.contains(word))?;
    Some(format!(
        "refused: it contains `{word}`; write your own code, with the names of the prelude"
    ))
}

/// The words after a name in the list of lessons.
fn words(name: &str) -> impl Iterator<Item = &'static str> {
    let after_name = |line: &'static str| line.strip_prefix(name)?.strip_prefix(' ');
    let words = LESSONS.lines().find_map(after_name);
    words.unwrap_or_default().split_whitespace()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files;

    #[test]
    fn files_that_take_the_lesson_are_refused_and_starters_are_not() {
        for e in crate::exercise::read_all().unwrap() {
            let starter = files::starter(e).unwrap();
            assert_eq!(refusal(e, &starter), None, "{}", e.name);
            let lesson = format!("pub use {}::*;\n{starter}", e.stage.replace('-', "_"));
            assert!(refusal(e, &lesson).is_some(), "{}", e.name);
            // The functions by which the check calls the lesson.
            let check = files::read(&format!("{}/tests/exercises/{}.rs", e.stage, e.name)).unwrap();
            let calls = check.split("pub fn check").next().unwrap();
            let is_called = words(e.name).next().is_some();
            assert!(!is_called || refusal(e, calls).is_some(), "{}", e.name);
        }
    }
}
