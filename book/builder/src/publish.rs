//! `cargo book publish FOLDER`: the book as static files.

use std::fs;
use std::path::{Path, PathBuf};

use crate::{file, pages};

/// Tells a page host not to process the pages, and us that a folder holds a published book.
const MARK: &str = ".nojekyll";

/// A folder for the book.
pub struct Destination(PathBuf);

impl Destination {
    /// A folder that is empty, missing, or holds a published book, which will be replaced.
    pub fn new(folder: &Path) -> Result<Self, String> {
        let folder = file::absolute(folder)?;
        let is_ours = folder.join(MARK).exists() || file::entries(&folder)?.is_empty();
        if !is_ours || folder.is_file() {
            let folder = folder.display();
            return Err(format!(
                "{folder} holds something else than a published book"
            ));
        }
        Ok(Self(folder))
    }

    /// Copies the built book into the folder.
    pub fn publish(&self) -> Result<(), String> {
        let folder = &self.0;
        let failed = |error| format!("cannot write {}: {error}", folder.display());
        if folder.exists() {
            fs::remove_dir_all(folder).map_err(failed)?;
        }
        let book = Path::new(pages::FOLDER);
        let mut bytes = 0;
        let files = file::files_below(book)?;
        for path in &files {
            let to = folder.join(path.strip_prefix(book).unwrap_or(path));
            if let Some(folder) = to.parent() {
                fs::create_dir_all(folder).map_err(failed)?;
            }
            file::copy(path, &to)?;
            bytes += fs::metadata(&to).map_err(failed)?.len();
        }
        file::write(&folder.join(MARK), "")?;
        let megabytes = bytes as f64 / 1e6;
        println!(
            "published in {}: {} files, {megabytes:.0} MB",
            folder.display(),
            files.len()
        );
        Ok(())
    }
}
