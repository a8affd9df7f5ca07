//! `files_in`: all files that a student has handed in, in a folder or zip file, also those in zip files within.
//!
//! Nothing is written, and no link is followed: so names such as `../../file` do no harm.

use std::collections::BTreeSet;
use std::fmt::Display;
use std::fs::{self, File};
use std::io::{Cursor, Read, Seek};
use std::path::Path;

use common::text;
use zip::ZipArchive;
use zip::read::ZipFile;

use crate::handed_file::{Content, HandedFile, is_added, is_archive, is_text};

/// The most KiB of a text, of a zip file within another one, and of both together.
const MAX_TEXT: u64 = 64;
const MAX_WITHIN: u64 = 64 * 1024;
const MAX_ALL: u64 = 256 * 1024;

/// The most KiB of any other file, and of all of them.
const MAX_OTHER: u64 = 16 * 1024;
const MAX_OTHERS: u64 = 64 * 1024;

/// The most files of a student.
const MAX_FILES: usize = 200_000;

const LINK: &str = "it is a link; hand in the file itself";

/// All files in a folder or zip file, or the file alone, in the order of their names.
pub fn files_in(place: &Path) -> Vec<HandedFile> {
    let mut search = Search {
        files: Vec::new(),
        max_files: MAX_FILES,
        bytes_left: MAX_ALL * 1024,
        bytes_left_of_others: MAX_OTHERS * 1024,
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
    /// How many bytes of texts, and of zip files within zip files, may still be read.
    bytes_left: u64,
    bytes_left_of_others: u64,
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
        let size = file.metadata().map_err(unreadable)?.len();
        self.file(file, size, path)
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
        mut bytes: impl Read + Seek,
        path: &[String],
        is_within: bool,
    ) -> Result<(), String> {
        const DAMAGED: &str = "it is no zip file, or a damaged one";
        for name in names_twice(&mut bytes).map_err(|_| DAMAGED)? {
            let problem = "of this name the zip file has two files; hand in one".to_owned();
            self.add_problem(joined(path, &name), Err(problem));
        }
        let mut archive = ZipArchive::new(bytes).map_err(|_| DAMAGED)?;
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
            let size = file.size();
            return self.file(file, size, path);
        }
        if is_within {
            return Err("it is a zip file in two others; unpack one".to_owned());
        }
        let bytes = read(file, MAX_WITHIN, MAX_ALL, &mut self.bytes_left)?;
        self.zip(Cursor::new(bytes), path, true)
    }

    /// An error if there are more files than may be.
    fn check_count(&self) -> Result<(), String> {
        if self.files.len() > self.max_files {
            return Err(format!("there are more than {} files", self.max_files));
        }
        Ok(())
    }

    /// Adds a file of this size.
    fn file(&mut self, file: impl Read, size: u64, path: &[String]) -> Result<(), String> {
        let name = name_of(path);
        if is_archive(name) {
            return Err("it is another archive than a zip file".to_owned());
        }
        let content = if is_text(name) {
            let bytes = read(file, MAX_TEXT, MAX_ALL, &mut self.bytes_left)?;
            Content::Text(text::from_file(bytes)?)
        } else if size > MAX_OTHER * 1024 {
            Content::LeftOut(larger_than(MAX_OTHER))
        } else {
            match read(file, MAX_OTHER, MAX_OTHERS, &mut self.bytes_left_of_others) {
                Ok(bytes) => Content::Bytes(bytes),
                Err(why) => Content::LeftOut(why),
            }
        };
        let path = path.to_vec();
        self.files.push(HandedFile { path, content });
        Ok(())
    }
}

/// The names that two files or more have in a zip file, of which `ZipArchive` shows the last one.
fn names_twice(bytes: &mut (impl Read + Seek)) -> Result<Vec<String>, rawzip::Error> {
    let mut buffer = vec![0; rawzip::RECOMMENDED_BUFFER_SIZE];
    let archive = rawzip::ZipArchive::from_seekable(bytes, &mut buffer)?;
    let mut entries = archive.entries(&mut buffer);
    let (mut names, mut twice) = (BTreeSet::new(), BTreeSet::new());
    while let Some(entry) = entries.next_entry()? {
        let name = String::from_utf8_lossy(entry.file_path().as_ref()).into_owned();
        if !entry.is_dir() && !parts(&name).any(is_added) && !names.insert(name.clone()) {
            twice.insert(name);
        }
    }
    Ok(twice.into_iter().collect())
}

/// The bytes of a file of at most `max` KiB. With those before it, it may have `max_all` KiB, of which these bytes
/// are left.
fn read(file: impl Read, max: u64, max_all: u64, bytes_left: &mut u64) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let most = (*bytes_left).min(max * 1024);
    let end = file.take(most + 1).read_to_end(&mut bytes);
    let count = bytes.len() as u64;
    // What is refused counts, too, so that no hand-in is read for hours.
    *bytes_left = bytes_left.saturating_sub(count);
    end.map_err(unreadable)?;
    if count > max * 1024 {
        return Err(larger_than(max));
    }
    if count > most {
        return Err(format!("with it there is more to read than {max_all} KiB"));
    }
    Ok(bytes)
}

fn larger_than(max: u64) -> String {
    format!("it is larger than {max} KiB")
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
            bytes_left_of_others: 0,
        };
        let walked = search.folder(folder.path(), &["Ada".to_owned()]);
        assert_eq!(walked, Err("there are more than 3 files".to_owned()));
        assert_eq!(search.files.len(), 4);
    }
}
