//! `Files`: the text files of the repository, and the pages of the book.

use std::collections::BTreeMap;
use std::path::Path;
use std::{fs, io};

/// The paths of all files, relative to the top of the repository, each with its text;
/// the text of pictures and other binary files is empty.
#[derive(Debug, Default)]
pub struct Files(BTreeMap<String, String>);

/// The folder of the book's pages.
pub const PAGES: &str = "book/src/";

/// The table of contents, which is no page.
pub const SUMMARY: &str = "book/src/SUMMARY.md";

impl Files {
    /// All files below the top, except build products and hidden files.
    pub fn read() -> io::Result<Self> {
        let mut files = Self::default();
        files.read_folder(&Path::new(env!("CARGO_MANIFEST_DIR")).join(".."), "")?;
        Ok(files)
    }

    fn read_folder(&mut self, folder: &Path, name: &str) -> io::Result<()> {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let file = entry.file_name();
            let file = file.to_string_lossy();
            let path = format!("{name}{file}");
            if file.starts_with('.') || matches!(&*file, "target" | "node_modules") || path == "out"
            {
                continue;
            }
            if entry.file_type()?.is_dir() {
                self.read_folder(&entry.path(), &format!("{path}/"))?;
                continue;
            }
            let is_text = matches!(ending(&path), "md" | "rs" | "toml" | "txt");
            let text = is_text.then(|| fs::read_to_string(entry.path()));
            self.0.insert(path, text.transpose()?.unwrap_or_default());
        }
        Ok(())
    }

    /// The text of a file, if there is one.
    pub fn text(&self, path: &str) -> Option<&str> {
        self.0.get(path).map(String::as_str)
    }

    /// Paths and texts below a folder, whose name ends in `/`.
    pub fn below(&self, folder: impl Into<String>) -> impl Iterator<Item = (&str, &str)> {
        let folder = folder.into();
        let all = self.0.iter().map(|(path, text)| (&**path, &**text));
        all.filter(move |(path, _)| path.starts_with(&folder))
    }

    /// Paths and texts of the book's pages.
    pub fn pages(&self) -> impl Iterator<Item = (&str, &str)> {
        let all = self.below(PAGES);
        all.filter(|(path, _)| ending(path) == "md" && *path != SUMMARY)
    }

    /// Paths and texts of the Rust files, but not of a student's own exercises, which no
    /// commit contains.
    pub fn rust(&self) -> impl Iterator<Item = (&str, &str)> {
        let is_own = |path: &str| path.contains("/exercises/") && path.matches('/').count() == 2;
        let all = self.below("");
        all.filter(move |(path, _)| ending(path) == "rs" && !is_own(path))
    }
}

/// The part of a path behind its last dot.
pub fn ending(path: &str) -> &str {
    path.rsplit_once('.').map_or("", |(_, ending)| ending)
}

/// The path of a file that the page `from` names by a relative path; none outside of
/// the repository.
pub fn resolve(from: &str, path: &str) -> Option<String> {
    let mut folders: Vec<_> = from.split('/').collect();
    folders.pop();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." => drop(folders.pop()?),
            name => folders.push(name),
        }
    }
    Some(folders.join("/"))
}

/// A mistake at the byte `at` of a file; lines are counted from 1.
pub fn complaint(path: &str, text: &str, at: usize, mistake: &str) -> String {
    let line = text[..at].matches('\n').count() + 1;
    format!("{path}:{line}: {mistake}")
}
