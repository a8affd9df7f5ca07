//! Files of the workbook, by their paths in it.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::{env, fs, io};

use common::{text, workbook};

/// The manifest of a program.
pub const MANIFEST: &str = "Cargo.toml";

/// The folder of the workbook: of the package that `cargo run` runs, or else around the current folder.
#[must_use]
pub fn workspace() -> PathBuf {
    static WORKSPACE: LazyLock<PathBuf> = LazyLock::new(|| {
        let above = |package: &Path| package.ancestors().nth(2).unwrap_or(package).to_owned();
        if let Some(package) = env::var_os("CARGO_MANIFEST_DIR") {
            return above(package.as_ref());
        }
        let built = above(env!("CARGO_MANIFEST_DIR").as_ref());
        workbook::with_file("common/learn/Cargo.toml", &built)
    });
    WORKSPACE.clone()
}

/// A path in the workbook: in the current folder, without that of the folder.
#[must_use]
pub fn shortest(path: &str) -> PathBuf {
    let whole = workspace().join(path);
    let here = env::current_dir().unwrap_or_default();
    whole
        .strip_prefix(here)
        .map_or(whole.clone(), Path::to_owned)
}

/// The text of a file in the workbook.
pub fn read(path: &str) -> Result<String, String> {
    fs::read_to_string(shortest(path)).map_err(with_path(path.as_ref()))
}

/// The text of a file of a student's, which may be saved in another encoding than UTF-8.
pub(crate) fn text_of(path: &Path) -> Result<String, String> {
    let bytes = fs::read(path).map_err(with_path(path))?;
    text::from_file(bytes).map_err(|problem| format!("{}: {problem}", text::path(path)))
}

/// An error about a file as words, which begin with its path.
pub fn with_path(path: &Path) -> impl Fn(io::Error) -> String {
    move |error| format!("{}: {error}", text::path(path))
}

/// Where a page of the book is: in a handout as it is read, else as it is written.
pub(crate) fn page(name: &str) -> String {
    let built = format!("book/{}.html", name.trim_end_matches(".md"));
    if workspace().join(&built).exists() {
        built
    } else {
        format!("book/src/{name}")
    }
}

/// What a file has now; none if there is no file.
pub(crate) fn existing(path: &Path) -> Result<Option<Vec<u8>>, String> {
    match fs::read(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        read => read.map(Some).map_err(with_path(path)),
    }
}

/// Writes a file, and makes its folder if there is none.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), String> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(with_path(folder))?;
    }
    fs::write(path, text).map_err(with_path(path))
}
