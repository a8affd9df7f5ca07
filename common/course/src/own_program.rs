//! `OwnProgram`: a student's own program, a folder with `Cargo.toml`, `src` and `sheet.txt`, whose text names the
//! open sheets that it is handed in for.

mod manifest;
#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Command;

use common::text;
use learn::files::with_path;

use crate::grading_folder::{GradingFolder, output_of};
use crate::handed_file::{Content, HandedFile};
use crate::sandbox::{End, Ended, Limits, Place};
pub use manifest::MANIFEST;
use manifest::manifest;

/// The file that names the open sheets of a program.
pub const SHEETS: &str = "sheet.txt";

/// A program that does nothing.
const EMPTY: &str = "fn main() {}\n";

/// A student's own program.
#[derive(Debug, Default)]
pub struct OwnProgram {
    /// Its folder, from what the student has handed in.
    pub folder: String,
    /// The names in `sheet.txt`.
    pub sheets: Vec<String>,
    manifest: String,
    /// The texts of the files below `src`, by their paths.
    sources: BTreeMap<String, String>,
    /// Why it cannot be judged.
    pub problem: Option<String>,
}

/// The programs in a hand-in; if there is none because it cannot be read, one that says so.
pub fn find(files: &[HandedFile]) -> Vec<OwnProgram> {
    let folders = folders(files);
    if !folders.is_empty() {
        return folders
            .iter()
            .map(|folder| OwnProgram::new(files, folder))
            .collect();
    }
    let unread = files.iter().find_map(|file| match &file.content {
        Content::Problem(problem) => Some((file.shown(), problem.clone())),
        _ => None,
    });
    let empty = files
        .is_empty()
        .then(|| (String::new(), "it is empty".to_owned()));
    let program = unread.or(empty).map(|(folder, problem)| OwnProgram {
        folder,
        problem: Some(problem),
        ..OwnProgram::default()
    });
    program.into_iter().collect()
}

/// The folders of programs, without those within another one.
fn folders(files: &[HandedFile]) -> Vec<Vec<String>> {
    let folders_of = |wanted: &str| -> BTreeSet<Vec<String>> {
        let named = files
            .iter()
            .filter(|file| file.path.last().is_some_and(|name| name == wanted));
        named
            .map(|file| file.path[..file.path.len() - 1].to_vec())
            .collect()
    };
    let with_sheets = folders_of(SHEETS);
    let mut folders: Vec<_> = with_sheets.iter().cloned().collect();
    for folder in folders_of(MANIFEST) {
        let is_around =
            |other: &Vec<String>| other.starts_with(&folder) || folder.starts_with(other);
        if !folders.iter().any(is_around) {
            folders.push(folder);
        }
    }
    folders
}

impl OwnProgram {
    fn new(files: &[HandedFile], folder: &[String]) -> Self {
        let mut program = Self {
            folder: text::visible(&folder.join("/")),
            ..Self::default()
        };
        let mut problems = Vec::new();
        for file in files {
            let Some(inner) = file.path.strip_prefix(folder) else {
                continue;
            };
            let path = inner.join("/");
            let is_source = inner.first().is_some_and(|first| first == "src");
            match &file.content {
                Content::Text(text) if path == MANIFEST => program.manifest.clone_from(text),
                Content::Text(text) if path == SHEETS => {
                    program.sheets = text.split_whitespace().map(str::to_owned).collect();
                }
                Content::Text(text) if is_source => {
                    program.sources.insert(path, text.clone());
                }
                Content::Problem(problem) => problems.push(format!("{path}: {problem}")),
                _ => {}
            }
        }
        let lacks = |name: &str| format!("it has no {name}");
        if program.manifest.is_empty() {
            problems.push(lacks(MANIFEST));
        }
        if program.sheets.is_empty() {
            problems.push(lacks("sheet.txt, which names the sheet"));
        }
        program.problem = problems.into_iter().next();
        program
    }

    /// Builds the program in the grading folder. An error is a problem of its manifest, or of the grader.
    pub fn build(&self, folder: &GradingFolder) -> Result<Ended, String> {
        let manifest = manifest(&self.manifest)?;
        build(folder, &manifest, &self.sources, Limits::Build)
    }
}

/// Builds the workbook's crates as programs use them.
pub fn prepare(folder: &GradingFolder) -> Result<(), String> {
    let _lock = folder.lock()?;
    let sources = BTreeMap::from([("src/main.rs".to_owned(), EMPTY.to_owned())]);
    let built = build(folder, &manifest("")?, &sources, Limits::All)?;
    match built.end {
        End::Success => Ok(()),
        _ => Err(format!("no program builds\n{}", built.output)),
    }
}

fn build(
    folder: &GradingFolder,
    manifest: &str,
    sources: &BTreeMap<String, String>,
    limits: Limits,
) -> Result<Ended, String> {
    let root = folder.sandbox.folder.join("program");
    // Nothing of the one before remains.
    if root.exists() {
        fs::remove_dir_all(&root).map_err(with_path(&root))?;
    }
    let write = |path: &str, bytes: &[u8]| {
        let file = root.join(path);
        let folder = file.parent().unwrap_or(Path::new(""));
        fs::create_dir_all(folder).map_err(with_path(folder))?;
        fs::write(&file, bytes).map_err(with_path(&file))
    };
    for (path, text) in sources {
        write(path, text.as_bytes())?;
    }
    write(MANIFEST, manifest.as_bytes())?;
    // The versions of libraries that the workbook has fetched.
    let lock = folder.sandbox.folder.join("workbook/Cargo.lock");
    write("Cargo.lock", &fs::read(&lock).map_err(with_path(&lock))?)?;
    let mut cargo = Command::new("cargo");
    cargo.args(["update", "--workspace", "--offline", "--quiet"]);
    output_of(cargo.current_dir(&root))?;
    let words = "cargo build --release --offline --quiet --message-format json-render-diagnostics";
    folder.sandbox.run(limits, Place::Program, words.split(' '))
}
