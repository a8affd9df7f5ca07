//! `files_in`: all files that a student has handed in, in a folder or zip file, also those in zip files within.
//!
//! Nothing is written, and no link is followed: so names such as `../../file` do no harm.

use std::borrow::Cow;
use std::fs::{self, File};
use std::io::{Cursor, Read, Seek};
use std::path::Path;

use common::text;
use zip::ZipArchive;
use zip::result::ZipError;

use crate::handed_file::{Content, HandedFile, is_added, is_archive, is_wanted};

/// The most bytes of a student's file.
const MOST: u64 = 64 * 1024;

/// The most bytes of a zip file within another one, and of all such and of all files that are read.
const MAX_WITHIN: u64 = 64 * 1024 * 1024;
const MOST_OF_ALL: u64 = 256 * 1024 * 1024;

/// The most files of a student.
const MAX_FILES: usize = 200_000;

/// All files in a folder or zip file, or the file alone, in the order of their names. Only files are read whose
/// names the grader knows.
pub fn files_in(place: &Path) -> Vec<HandedFile> {
    let mut search = Search {
        files: Vec::new(),
        most_files: MAX_FILES,
        bytes_left: MOST_OF_ALL,
    };
    let name = place.file_name().unwrap_or(place.as_os_str());
    search.place(place, vec![name.to_string_lossy().into_owned()]);
    search.files.sort_by(|a, b| a.path.cmp(&b.path));
    search.files
}

/// The parts of a name in a folder or zip file, in which some tools write `\` instead of `/`.
fn parts(name: &str) -> impl Iterator<Item = &str> {
    let parts = name.split(['/', '\\']);
    parts.filter(|part| !["", ".", ".."].contains(part))
}

/// Whether this is the name of a zip file.
fn is_zip(name: &str) -> bool {
    let extension = Path::new(name).extension();
    extension.is_some_and(|extension| extension.eq_ignore_ascii_case("zip"))
}

/// A search for files, and what it has found.
struct Search {
    files: Vec<HandedFile>,
    most_files: usize,
    /// How many bytes of files, and of zip files within zip files, may still be read.
    bytes_left: u64,
}

impl Search {
    fn place(&mut self, place: &Path, path: Vec<String>) {
        match fs::symlink_metadata(place).map(|place| place.file_type()) {
            Ok(kind) if kind.is_dir() => self.folder(place, &path),
            Ok(kind) if kind.is_file() => self.file_on_disk(place, path),
            Ok(kind) if kind.is_symlink() => {
                self.found(path, problem("it is a link; hand in the file itself"));
            }
            Ok(_) => self.found(path, problem("it is neither a file nor a folder")),
            Err(error) => self.found(path, problem(format!("it cannot be read: {error}"))),
        }
    }

    fn folder(&mut self, folder: &Path, path: &[String]) {
        let entries = match fs::read_dir(folder) {
            Ok(entries) => entries,
            Err(error) => {
                self.found(
                    path.to_vec(),
                    problem(format!("it cannot be read: {error}")),
                );
                return;
            }
        };
        for entry in entries.flatten() {
            if self.is_full(path) {
                return;
            }
            let name = entry.file_name().to_string_lossy().into_owned();
            if is_added(&name) {
                continue;
            }
            let mut inner = path.to_vec();
            inner.extend(parts(&name).map(str::to_owned));
            self.place(&entry.path(), inner);
        }
    }

    fn file_on_disk(&mut self, place: &Path, path: Vec<String>) {
        match File::open(place) {
            Ok(file) if path.last().is_some_and(|name| is_zip(name)) => {
                self.zip(file, &path, false);
            }
            Ok(file) => self.file(file, path),
            Err(error) => self.found(path, problem(format!("it cannot be read: {error}"))),
        }
    }

    /// The files in a zip file, which may be within another one.
    fn zip(&mut self, bytes: impl Read + Seek, path: &[String], is_within: bool) {
        let Ok(mut archive) = ZipArchive::new(bytes) else {
            let why = "it is no zip file, or a damaged one";
            self.found(path.to_vec(), problem(why));
            return;
        };
        for index in 0..archive.len() {
            if self.is_full(path) {
                return;
            }
            // Its name can be read also where its content cannot.
            let mut inner = path.to_vec();
            match archive.by_index_raw(index) {
                Ok(file) => {
                    let name = String::from_utf8_lossy(file.name_raw()).into_owned();
                    let name = file.name().map_or(name, Cow::into_owned);
                    if parts(&name).any(is_added) {
                        continue;
                    }
                    inner.extend(parts(&name).map(str::to_owned));
                }
                Err(error) => {
                    self.found(inner, problem(in_words(&error)));
                    continue;
                }
            }
            match archive.by_index(index) {
                Ok(file) if file.is_symlink() => {
                    self.found(inner, problem("it is a link; hand in the file itself"));
                }
                Ok(file) if file.is_dir() => {}
                Ok(file) if inner.last().is_some_and(|name| is_zip(name)) => {
                    if is_within {
                        let why = "it is a zip file in two others; unpack one";
                        self.found(inner, problem(why));
                    } else {
                        self.zip_within(file, &inner);
                    }
                }
                Ok(file) => self.file(file, inner),
                Err(error) => self.found(inner, problem(in_words(&error))),
            }
        }
    }

    /// Whether there are more files than may be: then this folder or zip file is a problem.
    fn is_full(&mut self, path: &[String]) -> bool {
        let is_full = self.files.len() > self.most_files;
        if is_full {
            let why = format!("with it there are more than {} files", self.most_files);
            self.found(path.to_vec(), problem(why));
        }
        is_full
    }

    /// The files in a zip file within another one, which is read as a whole.
    fn zip_within(&mut self, archive: impl Read, path: &[String]) {
        let most = MAX_WITHIN.min(self.bytes_left);
        let mut bytes = Vec::new();
        let read = archive.take(most + 1).read_to_end(&mut bytes);
        let count = bytes.len() as u64;
        self.bytes_left = self.bytes_left.saturating_sub(count);
        if read.is_err() {
            self.found(path.to_vec(), problem("it is damaged"));
        } else if count > most {
            let why = "it is a zip file of more than 64 MiB within another one";
            self.found(path.to_vec(), problem(why));
        } else {
            self.zip(Cursor::new(bytes), path, true);
        }
    }

    fn file(&mut self, file: impl Read, path: Vec<String>) {
        let name = path.last().map_or("", String::as_str);
        let content = if is_archive(name) {
            problem("it is another archive than a zip file")
        } else if is_wanted(name) {
            self.text_in(file)
        } else {
            Content::NotWanted
        };
        self.found(path, content);
    }

    /// The text of a file of a student.
    fn text_in(&mut self, file: impl Read) -> Content {
        let mut bytes = Vec::new();
        let most = MOST.min(self.bytes_left);
        if file.take(most + 1).read_to_end(&mut bytes).is_err() {
            return problem("it is damaged");
        }
        let count = bytes.len() as u64;
        self.bytes_left = self.bytes_left.saturating_sub(count);
        match count {
            0..=MOST if count <= most => {
                text::from_file(bytes).map_or_else(Content::Problem, Content::Text)
            }
            0..=MOST => problem("with it there is more text than 256 MiB"),
            _ => problem("it is larger than 64 KiB"),
        }
    }

    fn found(&mut self, path: Vec<String>, content: Content) {
        self.files.push(HandedFile { path, content });
    }
}

fn problem(why: impl Into<String>) -> Content {
    Content::Problem(why.into())
}

/// Why a file in a zip file cannot be read.
fn in_words(error: &ZipError) -> String {
    match error {
        ZipError::UnsupportedArchive(ZipError::PASSWORD_REQUIRED) => "it is encrypted".to_owned(),
        ZipError::UnsupportedArchive(_) => {
            "it is compressed in a way that is not supported; use the usual one".to_owned()
        }
        _ => "it is damaged".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_with_too_many_files_is_not_walked_to_its_end() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a", "b", "c", "d", "e", "f"] {
            fs::write(folder.path().join(name), "").unwrap();
        }
        let mut search = Search {
            files: Vec::new(),
            most_files: 3,
            bytes_left: 0,
        };
        search.folder(folder.path(), &["Ada".to_owned()]);
        let last = search.files.pop().unwrap();
        assert_eq!(last.path, ["Ada"]);
        let why = "with it there are more than 3 files";
        assert_eq!(last.content, Content::Problem(why.to_owned()));
        assert_eq!(search.files.len(), 4);
    }
}
