//! `OwnProgram`: a student's own program, a folder with `sheet.txt`, whose text names the open sheets that it is
//! handed in for. It is judged as its own `cargo run` runs it: with all files of its folder, and its whole manifest.

mod manifest;
mod sheet_list;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use common::text;
use judge::pictures::Sheet;
use learn::files::with_path;
use learn::sheet;
use serde_json::Value;

use crate::grading_folder::GradingFolder;
use crate::handed_file::{Content, HandedFile, MANIFEST, SHEETS, is_brought, is_rust};
use crate::program_output::output_of;
use crate::sandbox::{End, Ended, Limits, Place, empty};
use crate::structure::ComparedFile;
use manifest::{CRATES, in_grading_folder};
use sheet_list::SheetList;

/// A program that does nothing.
const EMPTY: &str = "fn main() {}\n";

/// Files that change how Cargo builds all programs of a folder. The grader's own ones hold.
const CARGO_SETTINGS: [&str; 3] = [".cargo", "rust-toolchain", "rust-toolchain.toml"];

/// The lock of the workbook, with the versions of libraries that it has fetched.
const LOCK: &str = "Cargo.lock";

/// A student's own program.
#[derive(Debug, Default)]
pub struct OwnProgram {
    /// Its folder, from what the student has handed in.
    pub folder: String,
    /// The bytes of its files, by their paths in the folder.
    files: BTreeMap<String, Vec<u8>>,
    /// Which of its files the program runs without, and why.
    pub left_out: Vec<String>,
    /// The words that start a program that Cargo does not build.
    pub command: Option<Vec<String>>,
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
        let Content::Text(text) = &file.content else {
            continue;
        };
        let list = SheetList::read(text);
        if list.names.is_empty() {
            return Err(format!("{}: it names no sheet", file.path_text()));
        }
        for name in &list.names {
            let named = sheet::find(all, name);
            let named = named.map_err(|problem| format!("{}: {problem}", file.path_text()))?;
            if named.name == sheet.name && !found.iter().any(|(other, _)| *other == folder) {
                found.push((folder, list.command.clone()));
            }
        }
    }
    match &mut found[..] {
        [] => without_program(files, &programs),
        [(folder, command)] => OwnProgram::new(files, folder, command.take()).map(Some),
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
            return Err(format!("{}: {problem}", file.path_text()));
        }
        let folder = file.folder();
        let is_around = |other: &&[String]| other.starts_with(folder) || folder.starts_with(other);
        if file.name() == MANIFEST && !programs.iter().any(is_around) {
            let problem = "beside it is no sheet.txt, which names the sheet";
            return Err(format!("{}: {problem}", file.path_text()));
        }
    }
    Ok(None)
}

impl OwnProgram {
    /// The program in a folder, all of whose texts can be read.
    fn new(
        files: &[HandedFile],
        folder: &[String],
        command: Option<Vec<String>>,
    ) -> Result<Self, String> {
        let mut program = Self {
            folder: text::visible(&folder.join("/")),
            command,
            ..Self::default()
        };
        for file in files {
            let Some(inner) = file.path.strip_prefix(folder) else {
                continue;
            };
            let bytes = match &file.content {
                Content::Problem(problem) => {
                    return Err(format!("{}: {problem}", file.path_text()));
                }
                Content::LeftOut(why) => {
                    program
                        .left_out
                        .push(format!("{}: {why}", file.path_text()));
                    continue;
                }
                Content::Text(text) => text.clone().into_bytes(),
                Content::Bytes(bytes) => bytes.clone(),
            };
            if inner.iter().any(|part| CARGO_SETTINGS.contains(&&**part)) {
                let why = "the grader's own settings of Cargo hold";
                program
                    .left_out
                    .push(format!("{}: {why}", file.path_text()));
                continue;
            }
            program.files.insert(inner.join("/"), bytes);
        }
        if program.command.is_none() && !program.files.contains_key(MANIFEST) {
            return Err(format!("{}: it has no {MANIFEST}", program.folder));
        }
        Ok(program)
    }

    /// The files of its code, without the functions that `cargo learn program` has brought.
    pub fn compared_files(&self) -> Vec<ComparedFile> {
        let mut compared = Vec::new();
        for (path, bytes) in &self.files {
            if is_rust(path) && !is_brought(path) {
                compared.extend(ComparedFile::read(path, &String::from_utf8_lossy(bytes)));
            }
        }
        compared
    }

    /// Writes the program into the grading folder, and builds the one that `cargo run` runs, unless a command starts it.
    /// Returns its name, too. An error says why nobody can judge it there.
    pub fn build(&self, folder: &GradingFolder) -> Result<Option<(Ended, String)>, String> {
        let mut files = self.files.clone();
        if self.command.is_some() {
            write(folder, &files)?;
            return Ok(None);
        }
        for (path, bytes) in &mut files {
            let depth = path.matches('/').count();
            if path.rsplit('/').next() == Some(MANIFEST) {
                let text = String::from_utf8_lossy(bytes);
                let manifest = in_grading_folder(&text, depth);
                *bytes = manifest.map_err(|why| format!("{path}: {why}"))?.into();
            }
        }
        build(folder, files, Limits::Build).map(Some)
    }
}

/// Builds the workbook's crates as the programs use them that `cargo learn program` has completed.
pub fn prepare(folder: &GradingFolder) -> Result<(), String> {
    let _lock = folder.lock()?;
    let manifest = "[package]\nname = \"program\"\nedition = \"2024\"\n".to_owned();
    let (manifest, _) = learn::complete_manifest(manifest, &CRATES[1..])?;
    let files = BTreeMap::from([
        (MANIFEST.to_owned(), in_grading_folder(&manifest, 0)?.into()),
        ("src/main.rs".to_owned(), EMPTY.into()),
    ]);
    let (built, _) = build(folder, files, Limits::All)?;
    match built.end {
        End::Success => Ok(()),
        _ => Err(format!("no program builds\n{}", built.output)),
    }
}

/// Writes the files of a program into the grading folder, in which nothing of an earlier one is.
fn write(folder: &GradingFolder, files: &BTreeMap<String, Vec<u8>>) -> Result<(), String> {
    let root = folder.sandbox.folder.join("program");
    empty(&root)?;
    for (path, bytes) in files {
        let file = root.join(path);
        let folder = file.parent().unwrap_or(Path::new(""));
        fs::create_dir_all(folder).map_err(with_path(folder))?;
        fs::write(&file, bytes).map_err(with_path(&file))?;
    }
    Ok(())
}

fn build(
    folder: &GradingFolder,
    mut files: BTreeMap<String, Vec<u8>>,
    limits: Limits,
) -> Result<(Ended, String), String> {
    let lock = folder.sandbox.folder.join("workbook").join(LOCK);
    files.insert(LOCK.to_owned(), fs::read(&lock).map_err(with_path(&lock))?);
    write(folder, &files)?;
    let root = folder.sandbox.folder.join("program");
    let mut cargo = Command::new("cargo");
    cargo.args(["update", "--workspace", "--offline", "--quiet"]);
    output_of(cargo.current_dir(&root))?;
    let metadata = learn::metadata(&root)?;
    check_packages(&metadata)?;
    let name = learn::program_of(&metadata)?;
    let words =
        "cargo build --release --offline --quiet --message-format json-render-diagnostics --bin";
    let words = words.split(' ').chain([&*name]);
    let built = folder.sandbox.run(limits, Place::Program, words)?;
    Ok((built, name))
}

/// An error if a package of the program runs code while it is compiled, because then it could write into the folder of
/// all builds.
fn check_packages(metadata: &Value) -> Result<(), String> {
    for package in metadata["packages"].as_array().into_iter().flatten() {
        for target in package["targets"].as_array().into_iter().flatten() {
            for kind in target["kind"].as_array().into_iter().flatten() {
                if kind == "custom-build" || kind == "proc-macro" {
                    let name = text::name(package["name"].as_str().unwrap_or_default());
                    return Err(format!("{name} has code that runs while it is compiled"));
                }
            }
        }
    }
    Ok(())
}
