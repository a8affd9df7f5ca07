//! `Files`: the repository, as far as the book speaks of it.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::page::Page;

/// The paths of all files, from the top of the repository with `/` in between,
/// each with its text; the text of pictures and other binary files is empty.
#[derive(Debug, Default)]
pub struct Files(BTreeMap<String, String>);

/// Where the book's pages lie.
pub const PAGES: &str = "book/src/";

/// The list of chapters, which is no page.
pub const SUMMARY: &str = "book/src/SUMMARY.md";

/// The top of the repository.
pub fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

impl Files {
    /// All files below the top, but those that are made by building.
    pub fn read() -> io::Result<Self> {
        let mut files = Self::default();
        files.read_folder(&top(), "")?;
        Ok(files)
    }

    fn read_folder(&mut self, folder: &Path, name: &str) -> io::Result<()> {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let path = format!("{name}{}", entry.file_name().to_string_lossy());
            if is_made(&path) {
                continue;
            }
            if entry.file_type()?.is_dir() {
                self.read_folder(&entry.path(), &format!("{path}/"))?;
                continue;
            }
            let text = if matches!(ending(&path), "md" | "rs" | "toml") {
                fs::read_to_string(entry.path())?
            } else {
                String::new()
            };
            self.0.insert(path, text);
        }
        Ok(())
    }

    /// The text of a file, if there is one.
    #[must_use]
    pub fn text(&self, path: &str) -> Option<&str> {
        self.0.get(path).map(String::as_str)
    }

    /// Paths and texts below a folder, whose name ends in `/`.
    pub fn below<'a>(&'a self, folder: &str) -> impl Iterator<Item = (&'a str, &'a str)> {
        let all = self.0.iter().map(|(path, text)| (&**path, &**text));
        all.filter(move |(path, _)| path.starts_with(folder))
    }

    /// The pages of the book.
    pub fn pages(&self) -> impl Iterator<Item = Page<'_>> {
        let all = self.below(PAGES);
        all.filter(|(path, _)| ending(path) == "md" && *path != SUMMARY)
            .map(|(path, text)| Page { path, text })
    }

    /// The folders of the stages, from the first to the last.
    pub fn stages(&self) -> impl Iterator<Item = &str> {
        let manifests = self
            .0
            .keys()
            .filter_map(|path| path.strip_suffix("/Cargo.toml"));
        manifests.filter(|folder| folder.starts_with("a0") && !folder.contains('/'))
    }

    /// Files of a test.
    #[cfg(test)]
    pub(crate) fn of<const N: usize>(files: [(&str, &str); N]) -> Self {
        Self(files.map(|(path, text)| (path.into(), text.into())).into())
    }
}

/// Whether a path belongs to build products or to other programs.
fn is_made(path: &str) -> bool {
    path.starts_with('.') || path == "target" || path == "out"
}

/// The text behind the last dot of a path.
pub fn ending(path: &str) -> &str {
    path.rsplit_once('.').map_or("", |(_, ending)| ending)
}

/// Where a path leads that is written in the file `from`; none if it leaves
/// the repository.
pub fn resolve(from: &str, path: &str) -> Option<String> {
    let mut folders: Vec<_> = from.split('/').collect();
    folders.pop();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." => {
                folders.pop()?;
            }
            name => folders.push(name),
        }
    }
    Some(folders.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_count_from_the_file_they_are_written_in() {
        let from = "book/src/chapter.md";
        let leads = |path| resolve(from, path);
        assert_eq!(leads("a.md").as_deref(), Some("book/src/a.md"));
        assert_eq!(
            leads("./pictures/a.png").as_deref(),
            Some("book/src/pictures/a.png")
        );
        assert_eq!(
            leads("../../common/src/a.rs").as_deref(),
            Some("common/src/a.rs")
        );
        assert_eq!(leads("../../../a.rs"), None);
    }

    #[test]
    fn the_stages_are_those_of_the_workspace() {
        let files = Files::read().unwrap();
        let manifest = files.text("Cargo.toml").unwrap();
        assert_eq!(files.stages().count(), 7);
        for stage in files.stages() {
            assert!(manifest.contains(&format!("\"{stage}\"")), "{stage}");
        }
    }

    #[test]
    fn what_is_made_is_not_read() {
        assert!([".git", "target", "out"].into_iter().all(is_made));
        let read = ["book", "README.md", "a01/out", "fuzz/target"];
        assert!(!read.into_iter().any(is_made));
    }
}
