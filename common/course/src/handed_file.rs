//! `HandedFile`: a file in a hand-in, and what its name says.

use std::path::Path;

use common::text;
pub use learn::{MANIFEST, SHEETS, is_added};

/// Extensions of archives, of which only zip files are opened.
const ARCHIVES: [&str; 9] = ["7z", "bz2", "gz", "rar", "tar", "tgz", "xz", "zip", "zst"];

/// A file in a hand-in.
#[derive(Clone, Debug, PartialEq)]
pub struct HandedFile {
    /// What the student has handed in, the folders and zip files in it, and its own name.
    pub path: Vec<String>,
    pub content: Content,
}

impl HandedFile {
    pub fn name(&self) -> &str {
        self.path.last().map_or("", String::as_str)
    }

    /// The folder or zip file around it, whose path has a part less.
    pub fn folder(&self) -> &[String] {
        self.path.split_last().map_or(&[], |(_, folder)| folder)
    }

    /// The folders and zip files around it, below what the student has handed in.
    pub fn folders(&self) -> &[String] {
        self.folder().get(1..).unwrap_or_default()
    }

    /// Its path on one line.
    pub fn path_text(&self) -> String {
        text::visible(&self.path.join("/"))
    }
}

/// What is known of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// Rust, or one of the two other files that the grader itself reads.
    Text(String),
    /// Any other file, which a program may need, such as a picture.
    Bytes(Vec<u8>),
    /// Why such a file is left out.
    LeftOut(String),
    /// Why a text cannot be read.
    Problem(String),
}

/// Whether the grader itself reads files of this name: Rust, and the two files of a program.
pub fn is_text(name: &str) -> bool {
    is_rust(name) || [MANIFEST, SHEETS].contains(&name)
}

/// Whether this is the name of a Rust file.
pub fn is_rust(name: &str) -> bool {
    name.to_lowercase().ends_with(".rs")
}

/// Whether a file may have the code of an exercise, perhaps under a name that a system has changed, such as
/// `sphere.rs.txt`.
pub fn may_be_rust(name: &str) -> bool {
    let name = name.to_lowercase() + ".";
    name.contains(".rs.")
}

/// Whether `cargo learn program` has brought the file of this path into a program.
pub fn is_brought(path: &str) -> bool {
    path == "src/functions.rs" || path.starts_with("src/functions/")
}

/// Whether this is the name of an archive.
pub fn is_archive(name: &str) -> bool {
    let extension = Path::new(name).extension().unwrap_or_default();
    ARCHIVES
        .iter()
        .any(|archive| extension.eq_ignore_ascii_case(archive))
}
