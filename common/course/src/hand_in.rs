//! `files_in`: all files that a student has handed in, in a folder or zip file, also those in zip files within.
//!
//! Nothing is written, and no link is followed: so names such as `../../file` do no harm.

use std::fmt::Display;
use std::fs::{self, File};
use std::io::{Cursor, Read, Seek};
use std::path::Path;

use common::text;
use zip::ZipArchive;
use zip::read::ZipFile;

use crate::handed_file::{Content, HandedFile, is_added, is_archive, is_wanted};

/// The most KiB of a student's file, of a zip file within another one, and of all that is read.
const MAX_TEXT: u64 = 64;
const MAX_WITHIN: u64 = 64 * 1024;
const MAX_ALL: u64 = 256 * 1024;

/// The most files of a student.
const MAX_FILES: usize = 200_000;

const LINK: &str = "it is a link; hand in the file itself";

/// All files in a folder or zip file, or the file alone, in the order of their names. Only files are read whose
/// names the grader knows.
pub fn files_in(place: &Path) -> Vec<HandedFile> {
    let mut search = Search {
        files: Vec::new(),
        max_files: MAX_FILES,
        bytes_left: MAX_ALL * 1024,
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

/// The path of a name in a folder or zip file.
fn joined(path: &[String], name: &str) -> Vec<String> {
    let inner = parts(name).map(str::to_owned);
    path.iter().cloned().chain(inner).collect()
}

/// The name of a file by its path.
fn name_of(path: &[String]) -> &str {
    path.last().map_or("", String::as_str)
}

/// Whether this is the name of a zip file.
fn is_zip(name: &str) -> bool {
    let extension = Path::new(name).extension();
    extension.is_some_and(|extension| extension.eq_ignore_ascii_case("zip"))
}

fn unreadable(error: impl Display) -> String {
    format!("it cannot be read: {error}")
}

/// A search for files, and what it has found. An error says why a place cannot be read.
struct Search {
    files: Vec<HandedFile>,
    max_files: usize,
    /// How many bytes of files, and of zip files within zip files, may still be read.
    bytes_left: u64,
}

impl Search {
    fn place(&mut self, place: &Path, path: Vec<String>) {
        let opened = self.open(place, &path);
        self.add_problem(path, opened);
    }

    /// A place that cannot be read is a file with a problem.
    fn add_problem(&mut self, path: Vec<String>, opened: Result<(), String>) {
        if let Err(problem) = opened {
            let content = Content::Problem(problem);
            self.files.push(HandedFile { path, content });
        }
    }

    fn open(&mut self, place: &Path, path: &[String]) -> Result<(), String> {
        let kind = fs::symlink_metadata(place).map_err(unreadable)?.file_type();
        if kind.is_symlink() {
            return Err(LINK.to_owned());
        }
        if kind.is_dir() {
            return self.folder(place, path);
        }
        if !kind.is_file() {
            return Err("it is neither a file nor a folder".to_owned());
        }
        let file = File::open(place).map_err(unreadable)?;
        if is_zip(name_of(path)) {
            return self.zip(file, path, false);
        }
        self.file(file, path)
    }

    fn folder(&mut self, folder: &Path, path: &[String]) -> Result<(), String> {
        for entry in fs::read_dir(folder).map_err(unreadable)? {
            let entry = entry.map_err(unreadable)?;
            self.check_count()?;
            let name = entry.file_name().to_string_lossy().into_owned();
            if !is_added(&name) {
                self.place(&entry.path(), joined(path, &name));
            }
        }
        Ok(())
    }

    /// The files in a zip file, which may be within another one.
    fn zip(
        &mut self,
        bytes: impl Read + Seek,
        path: &[String],
        is_within: bool,
    ) -> Result<(), String> {
        let archive = ZipArchive::new(bytes);
        let mut archive = archive.map_err(|_| "it is no zip file, or a damaged one")?;
        for index in 0..archive.len() {
            self.check_count()?;
            // Its name can be read also where its content cannot.
            let name = match archive.name_for_index(index) {
                Some(Ok(name)) => name.into_owned(),
                _ => format!("file {index}"),
            };
            if parts(&name).any(is_added) {
                continue;
            }
            let inner = joined(path, &name);
            let opened = archive.by_index(index).map_err(unreadable);
            let opened = opened.and_then(|file| self.file_in_zip(file, &inner, is_within));
            self.add_problem(inner, opened);
        }
        Ok(())
    }

    fn file_in_zip(
        &mut self,
        file: ZipFile<impl Read>,
        path: &[String],
        is_within: bool,
    ) -> Result<(), String> {
        if file.is_symlink() {
            return Err(LINK.to_owned());
        }
        if file.is_dir() {
            return Ok(());
        }
        if !is_zip(name_of(path)) {
            return self.file(file, path);
        }
        if is_within {
            return Err("it is a zip file in two others; unpack one".to_owned());
        }
        let bytes = self.read(file, MAX_WITHIN)?;
        self.zip(Cursor::new(bytes), path, true)
    }

    /// An error if there are more files than may be.
    fn check_count(&self) -> Result<(), String> {
        if self.files.len() > self.max_files {
            return Err(format!("there are more than {} files", self.max_files));
        }
        Ok(())
    }

    fn file(&mut self, file: impl Read, path: &[String]) -> Result<(), String> {
        let name = name_of(path);
        if is_archive(name) {
            return Err("it is another archive than a zip file".to_owned());
        }
        let mut content = Content::NotWanted;
        if is_wanted(name) {
            content = Content::Text(text::from_file(self.read(file, MAX_TEXT)?)?);
        }
        let path = path.to_vec();
        self.files.push(HandedFile { path, content });
        Ok(())
    }

    /// The bytes of a file, of which so many KiB may be.
    fn read(&mut self, file: impl Read, max: u64) -> Result<Vec<u8>, String> {
        let mut bytes = Vec::new();
        let most = self.bytes_left.min(max * 1024);
        let read = file.take(most + 1).read_to_end(&mut bytes);
        let count = bytes.len() as u64;
        self.bytes_left = self.bytes_left.saturating_sub(count);
        read.map_err(unreadable)?;
        if count > max * 1024 {
            return Err(format!("it is larger than {max} KiB"));
        }
        if count > most {
            return Err(format!("with it there is more to read than {MAX_ALL} KiB"));
        }
        Ok(bytes)
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
            max_files: 3,
            bytes_left: 0,
        };
        let walked = search.folder(folder.path(), &["Ada".to_owned()]);
        assert_eq!(walked, Err("there are more than 3 files".to_owned()));
        assert_eq!(search.files.len(), 4);
    }
}
