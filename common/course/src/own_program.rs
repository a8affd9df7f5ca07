//! `OwnProgram`: a student's own program, a folder with `Cargo.toml`, `src` and `sheet.txt`, whose text names the
//! open sheets that it is handed in for.

mod manifest;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use ::sheet::Sheet;
use common::text;
use learn::files::with_path;
use learn::sheet;

use crate::grading_folder::{GradingFolder, output_of};
use crate::handed_file::{Content, HandedFile};
use crate::sandbox::{End, Ended, Limits, Place};
use crate::sheet::empty;
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
    manifest: String,
    /// The texts of the files below `src`, by their paths.
    sources: BTreeMap<String, String>,
}

/// The program that is handed in for a sheet; none if there is no trace of one. An error says why a person has to
/// look.
pub fn find(
    files: &[HandedFile],
    sheet: &Sheet,
    all: &[Sheet],
) -> Result<Option<OwnProgram>, String> {
    let (mut programs, mut found) = (Vec::new(), Vec::new());
    for file in files.iter().filter(|file| file.name() == SHEETS) {
        let folder = file.folder();
        programs.push(folder);
        let Content::Text(names) = &file.content else {
            continue;
        };
        for name in names.split_whitespace() {
            let named = sheet::find(all, name);
            let named = named.map_err(|problem| format!("{}: {problem}", file.shown()))?;
            if named.name == sheet.name {
                found.push(folder);
            }
        }
    }
    found.dedup();
    match found[..] {
        [] => without_program(files, &programs),
        [folder] => OwnProgram::new(files, folder).map(Some),
        _ => Err(format!(
            "there are {} programs for this sheet; hand in one",
            found.len()
        )),
    }
}

/// An error if there may be a program in what is handed in. Some have folders with libraries of their own, or lie
/// in one.
fn without_program(
    files: &[HandedFile],
    programs: &[&[String]],
) -> Result<Option<OwnProgram>, String> {
    if files.is_empty() {
        return Err("it is empty".to_owned());
    }
    for file in files {
        if let Content::Problem(problem) = &file.content {
            return Err(format!("{}: {problem}", file.shown()));
        }
        let folder = file.folder();
        let is_around = |other: &&[String]| other.starts_with(folder) || folder.starts_with(other);
        if file.name() == MANIFEST && !programs.iter().any(is_around) {
            let problem = "beside it is no sheet.txt, which names the sheet";
            return Err(format!("{}: {problem}", file.shown()));
        }
    }
    Ok(None)
}

impl OwnProgram {
    /// The program in a folder, in which all files can be read.
    fn new(files: &[HandedFile], folder: &[String]) -> Result<Self, String> {
        let mut program = Self {
            folder: text::visible(&folder.join("/")),
            ..Self::default()
        };
        for file in files {
            let Some(inner) = file.path.strip_prefix(folder) else {
                continue;
            };
            let path = inner.join("/");
            match &file.content {
                Content::Problem(problem) => return Err(format!("{}: {problem}", file.shown())),
                Content::Text(text) if path == MANIFEST => program.manifest.clone_from(text),
                Content::Text(text) if path.starts_with("src/") => {
                    program.sources.insert(path, text.clone());
                }
                _ => {}
            }
        }
        if program.manifest.is_empty() {
            return Err(format!("{}: it has no {MANIFEST}", program.folder));
        }
        Ok(program)
    }

    /// Builds the program that `cargo run` runs in the grading folder, and returns its name, too. An error is a problem
    /// of its manifest, or of the grader.
    pub fn build(&self, folder: &GradingFolder) -> Result<(Ended, String), String> {
        let manifest = manifest(&self.manifest)?;
        build(folder, &manifest, &self.sources, Limits::Build)
    }
}

/// Builds the workbook's crates as programs use them.
pub fn prepare(folder: &GradingFolder) -> Result<(), String> {
    let _lock = folder.lock()?;
    let sources = BTreeMap::from([("src/main.rs".to_owned(), EMPTY.to_owned())]);
    let (built, _) = build(folder, &manifest("")?, &sources, Limits::All)?;
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
) -> Result<(Ended, String), String> {
    let root = folder.sandbox.folder.join("program");
    empty(&root)?;
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
    let name = learn::program_of(&root)?;
    let words =
        "cargo build --release --offline --quiet --message-format json-render-diagnostics --bin";
    let words = words.split(' ').chain([&*name]);
    let built = folder.sandbox.run(limits, Place::Program, words)?;
    Ok((built, name))
}
