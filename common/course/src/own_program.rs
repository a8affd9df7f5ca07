//! `OwnProgram`: a student's own program, a folder with `Cargo.toml`, `src` and `sheet.txt`, whose text names the
//! open sheets that it is handed in for.

mod manifest;
#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use common::text;
use learn::files::with_path;

use crate::file_name::split_time;
use crate::grading_folder::{GradingFolder, output_of};
use crate::hand_in::{Content, HandedFile, files_in, is_zip};
use crate::sandbox::{End, Ended, Limits, Place};
use crate::submission::root;
use manifest::{MANIFEST, manifest};

const SHEETS: &str = "sheet.txt";

/// A program that does nothing.
const EMPTY: &str = "fn main() {}\n";

/// A student's own program.
#[derive(Debug, Default)]
pub struct OwnProgram {
    pub student: String,
    /// Its folder below the place that was handed in.
    pub folder: String,
    /// The names in `sheet.txt`.
    pub sheets: Vec<String>,
    manifest: String,
    /// The texts of the files below `src`, by their paths.
    sources: BTreeMap<String, String>,
    /// Why it cannot be judged.
    pub problem: Option<String>,
}

/// The programs in folders and zip files.
pub fn find(places: &[PathBuf]) -> io::Result<Vec<OwnProgram>> {
    let is_wanted = |name: &str| [MANIFEST, SHEETS].contains(&name) || is_rust(name);
    let mut programs = Vec::new();
    for place in places {
        let root = root(place)?;
        let files = files_in(place, &root, &is_wanted);
        let folders = folders(&files);
        // Students are told apart where the paths of their programs begin to differ; one alone is named by the
        // zip file, or by the first folder.
        let first = folders.first().cloned().unwrap_or_default();
        let is_common = |count: &usize| {
            folders
                .iter()
                .all(|folder| folder.starts_with(&first[..*count]))
        };
        let common = (0..=first.len()).rev().find(is_common).unwrap_or_default();
        let level = match folders.len() {
            1 if root.last().is_some_and(|name| is_zip(name)) => root.len() - 1,
            1 => root.len(),
            _ => common,
        };
        for folder in &folders {
            let student = folder
                .get(level)
                .or(folder.last())
                .cloned()
                .unwrap_or_default();
            let (student, _) = split_time(&student.replace(".zip", ""));
            let mut program = OwnProgram::new(&files, folder);
            program.student = text::visible(&student);
            program.folder = text::visible(&folder[root.len()..].join("/"));
            programs.push(program);
        }
    }
    programs.sort_by(|a, b| a.student.cmp(&b.student));
    Ok(programs)
}

fn is_rust(name: &str) -> bool {
    Path::new(name)
        .extension()
        .is_some_and(|extension| extension == "rs")
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
        let mut program = Self::default();
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
