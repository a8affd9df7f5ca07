//! `files_in`: all files in a folder or zip file, also those in zip files within.
//!
//! Nothing is written, and no link is followed: so names such as `../../file` do no harm.

use std::borrow::Cow;
use std::fs::{self, File};
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::path::Path;

use zip::ZipArchive;
use zip::result::ZipError;

/// The most bytes of a student's file.
const MOST: u64 = 64 * 1024;

/// The most bytes of a zip file within another one, and of all such in an argument.
const MOST_WITHIN: u64 = 64 * 1024 * 1024;
const MOST_OF_ALL: u64 = 1024 * 1024 * 1024;

/// The most files in an argument, and zip files around a file.
const MOST_FILES: usize = 200_000;
const MOST_NESTED: usize = 5;

/// The number of entries in the last bytes of a zip file that has the true one elsewhere.
const MANY: u16 = 0xffff;

/// Folders and files that systems and tools add.
const ADDED: [&str; 7] = [
    "__MACOSX",
    ".DS_Store",
    "Thumbs.db",
    "desktop.ini",
    ".git",
    ".learn",
    "target",
];

/// A file in a hand-in.
#[derive(Clone, Debug, PartialEq)]
pub struct HandedFile {
    /// The folders and zip files around it, and its own name.
    pub path: Vec<String>,
    pub content: Content,
}

/// The text of a file, if it is wanted and can be read.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    NotWanted,
    Text(String),
    /// Why it cannot be read.
    Problem(String),
}

/// All files in a folder or zip file, or the file alone, in the order of their names. The first
/// part of their paths is `path`. Only files are read whose names are wanted.
pub fn files_in(
    place: &Path,
    path: &[String],
    is_wanted: &dyn Fn(&str) -> bool,
) -> Vec<HandedFile> {
    let mut search = Search {
        is_wanted,
        files: Vec::new(),
        bytes_left: MOST_OF_ALL,
    };
    if place.is_dir() {
        search.folder(place, path);
    } else {
        search.file_on_disk(place, path.to_vec());
    }
    search.files.sort_by(|a, b| a.path.cmp(&b.path));
    search.files
}

/// The parts of a name in a folder or zip file, in which some tools write `\` instead of `/`.
fn parts(name: &str) -> impl Iterator<Item = &str> {
    let parts = name.split(['/', '\\']);
    parts.filter(|part| !["", ".", ".."].contains(part))
}

/// Whether the last part of a path is the name of a zip file.
fn is_zip(path: &[String]) -> bool {
    let name = path.last();
    name.is_some_and(|name| has_extension(name, "zip"))
}

/// Whether a name ends with this extension, in letters of either case.
pub fn has_extension(name: &str, extension: &str) -> bool {
    let found = Path::new(name).extension();
    found.is_some_and(|found| found.eq_ignore_ascii_case(extension))
}

/// A search for files, and what it has found.
struct Search<'a> {
    is_wanted: &'a dyn Fn(&str) -> bool,
    files: Vec<HandedFile>,
    /// How many bytes of zip files within zip files may still be read.
    bytes_left: u64,
}

impl Search<'_> {
    fn folder(&mut self, folder: &Path, path: &[String]) {
        let entries = match fs::read_dir(folder) {
            Ok(entries) => entries,
            Err(error) => {
                self.found(path.to_vec(), problem(format!("cannot be read: {error}")));
                return;
            }
        };
        for entry in entries.flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            if is_added(&name) {
                continue;
            }
            let mut inner = path.to_vec();
            inner.extend(parts(&name).map(str::to_owned));
            let place = entry.path();
            match entry.file_type() {
                Ok(kind) if kind.is_dir() => self.folder(&place, &inner),
                Ok(kind) if kind.is_file() => self.file_on_disk(&place, inner),
                _ => self.found(inner, problem("is a link; hand in the file itself")),
            }
        }
    }

    fn file_on_disk(&mut self, place: &Path, path: Vec<String>) {
        match File::open(place) {
            Ok(file) if is_zip(&path) => self.zip(file, &path, 0),
            Ok(file) => self.file(file, path),
            Err(error) => self.found(path, problem(format!("cannot be read: {error}"))),
        }
    }

    /// The files in a zip file, which is in so many others.
    fn zip(&mut self, mut bytes: impl Read + Seek, path: &[String], nested: usize) {
        let listed = number_of_entries(&mut bytes);
        let Ok(mut archive) = ZipArchive::new(bytes) else {
            let why = "is no zip file, or a damaged one";
            self.found(path.to_vec(), problem(why));
            return;
        };
        // Of several files of a name, the last one would hide the others.
        let is_listed = |listed: u16| listed != MANY && usize::from(listed) > archive.len();
        if listed.is_ok_and(is_listed) {
            self.found(path.to_vec(), problem("has several files of one name"));
            return;
        }
        for index in 0..archive.len() {
            if self.files.len() > MOST_FILES {
                let why = format!("has more than {MOST_FILES} files");
                self.found(path.to_vec(), problem(why));
                return;
            }
            // Its name can be read also where its content cannot.
            let mut inner = path.to_vec();
            match archive.by_index_raw(index) {
                Ok(file) if file.is_dir() => continue,
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
                    self.found(inner, problem("is a link; hand in the file itself"));
                }
                Ok(file) if is_zip(&inner) => self.zip_within(file, &inner, nested + 1),
                Ok(file) => self.file(file, inner),
                Err(error) => self.found(inner, problem(in_words(&error))),
            }
        }
    }

    /// The files in a zip file within another one, which is read as a whole.
    fn zip_within(&mut self, archive: impl Read, path: &[String], nested: usize) {
        let most = MOST_WITHIN.min(self.bytes_left);
        let mut bytes = Vec::new();
        let read = archive.take(most + 1).read_to_end(&mut bytes);
        let count = bytes.len() as u64;
        self.bytes_left = self.bytes_left.saturating_sub(count);
        if nested > MOST_NESTED {
            let why = format!("is a zip file in more than {MOST_NESTED} others");
            self.found(path.to_vec(), problem(why));
        } else if read.is_err() {
            self.found(path.to_vec(), problem("is damaged"));
        } else if count > most {
            let why = "is a zip file of more than 64 MiB within another one";
            self.found(path.to_vec(), problem(why));
        } else {
            self.zip(Cursor::new(bytes), path, nested);
        }
    }

    fn file(&mut self, file: impl Read, path: Vec<String>) {
        let name = path.last().map_or("", String::as_str);
        let content = if (self.is_wanted)(name) {
            text(file)
        } else {
            Content::NotWanted
        };
        self.found(path, content);
    }

    fn found(&mut self, path: Vec<String>, content: Content) {
        self.files.push(HandedFile { path, content });
    }
}

/// The number of entries that a zip file lists in its last bytes: the signature `PK` 5 6, three
/// numbers of two bytes, and this one. Behind its 22 bytes may be a comment of at most 64 KiB.
fn number_of_entries(file: &mut (impl Read + Seek)) -> io::Result<u16> {
    let size = file.seek(SeekFrom::End(0))?;
    file.seek(SeekFrom::Start(
        size.saturating_sub(22 + u64::from(u16::MAX)),
    ))?;
    let mut end = Vec::new();
    file.read_to_end(&mut end)?;
    let found = end
        .windows(12)
        .rev()
        .find(|bytes| bytes.starts_with(b"PK\x05\x06"));
    let bytes = found.ok_or(io::ErrorKind::InvalidData)?;
    Ok(u16::from_le_bytes([bytes[10], bytes[11]]))
}

fn problem(why: impl Into<String>) -> Content {
    Content::Problem(why.into())
}

/// Whether a system or a tool has added this file or folder.
fn is_added(name: &str) -> bool {
    ADDED.contains(&name) || name.starts_with("._")
}

/// The text of a file of a student.
fn text(file: impl Read) -> Content {
    let mut bytes = Vec::new();
    if file.take(MOST + 1).read_to_end(&mut bytes).is_err() {
        return problem("is damaged");
    }
    if bytes.len() as u64 > MOST {
        return problem("is larger than 64 KiB");
    }
    String::from_utf8(bytes).map_or_else(|_| problem("is no text in UTF-8"), Content::Text)
}

/// Why a file in a zip file cannot be read.
fn in_words(error: &ZipError) -> String {
    match error {
        ZipError::UnsupportedArchive(ZipError::PASSWORD_REQUIRED) => "is encrypted".to_owned(),
        ZipError::UnsupportedArchive(_) => {
            "is compressed in a way that is not supported; use the usual one".to_owned()
        }
        _ => "is damaged".to_owned(),
    }
}
