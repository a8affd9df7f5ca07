//! `own_program`: brings the functions of exercises into a program of the student's, outside of the workbook.
//!
//! The student has made the program by `cargo new`, and its `main.rs` is theirs: nothing here writes it.
//! Its file `functions.rs` is written anew each time; a file in `functions` only as long as the student has
//! not edited it there. Nothing is written before all is checked.

mod manifest;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf, absolute};

use common::text;

use crate::exercise::Exercise;
use crate::files::{self, MANIFEST, existing, with_path, write};
use crate::progress::Progress;
use crate::public_items::public_items;
use crate::screen::Screen;
use crate::{print, sheet, student_file, tokens};
use manifest::Manifest;
pub use manifest::complete as complete_manifest;

/// Exercises whose functions take types that only their checks have.
const LEFT_OUT: [&str; 2] = ["chain", "stripe"];

/// The stage of `mirror`, whose `trace` asks a tracer which lights reach a hit. This one calls the student's
/// `is_shadowed`.
const STAGE_OF_TRACER: &str = "a06-shadows-reflection";
const TRACER: &str = include_str!("own_program/recursive_tracer.rs");

/// How `functions.rs` begins if no person wrote it.
const FIRST_LINE: &str = "//! Your functions. `cargo learn program` writes this file anew";

/// The beginning of `functions.rs`.
const BEGINNING: &str = "\
//! Your functions. `cargo learn program` writes this file anew; of an exercise that is open, it takes the
//! workbook's function. Types such as `Image` are the workbook's, unless a file in `functions` defines them.

#![allow(unused, reason = \"a program calls the functions that it needs\")]

/// In a function of the workbook, the code that an exercise asks for.
macro_rules! missing {
    ($what:expr, $for_now:expr, $code:expr) => {
        $code
    };
}

pub use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI, TAU};

pub use common::*;
";

/// Brings your functions into a program of your own
#[derive(clap::Args)]
pub struct Command {
    /// The folder of the program, which `cargo new` has made
    folder: PathBuf,
}

impl Command {
    /// Brings the functions into the program, and returns which of them are the student's.
    pub fn run(&self, course: &[Exercise]) -> Result<String, String> {
        let folder = &self.folder;
        check_place(folder)?;
        let progress = Progress::read();
        let mut done = BTreeMap::new();
        for e in course.iter().filter(|e| progress.is_done(e)) {
            done.insert(e.name, files::text_of(&student_file::path(e))?);
        }
        let brought = Brought::new(folder, course, &done)?;
        let screen = Screen::new();
        print(&screen.wrap(&brought.manifest.words()))?;
        brought.write()?;
        let mut lines = Vec::new();
        for (words, names) in [
            ("your functions", &brought.yours),
            ("open, and so the workbook's", &brought.workbooks),
            ("edited there, and so left as they are", &brought.edited),
        ] {
            if !names.is_empty() {
                lines.push(format!("{words}: {}", names.join(", ")));
            }
        }
        let main = folder.join("src/main.rs");
        if !fs::read_to_string(&main).is_ok_and(|main| main.contains("mod functions;")) {
            let main = text::path(&main);
            lines.push(format!(
                "{main} calls them after the lines: mod functions; use functions::*;"
            ));
        }
        Ok(screen.wrap(&lines.join("\n")))
    }
}

/// An error if a folder is not that of a program, or lies within the workbook, whose folders stay as they are.
fn check_place(folder: &Path) -> Result<(), String> {
    let shown = text::path(folder);
    let whole = absolute(folder).map_err(with_path(folder))?;
    // Of a folder that is still to be made, the place is that of the folder around it.
    let place = whole.ancestors().find_map(|path| path.canonicalize().ok());
    let workbook = files::workspace();
    let workbook = workbook.canonicalize().map_err(with_path(&workbook))?;
    if place.is_some_and(|place| place.starts_with(workbook)) {
        return Err(format!(
            "{shown} is within the workbook, and a program of your own is outside of it: `cargo new ../my-tracer` \
             begins one. If you have begun it within the workbook, move it to ../my-tracer, and take its name out of \
             `members` in the workbook's {MANIFEST}"
        ));
    }
    if folder.join(MANIFEST).is_file() {
        return Ok(());
    }
    Err(format!(
        "{shown} has no {MANIFEST}: `cargo new {shown}` begins a program, and this brings your functions into it"
    ))
}

/// What is brought: the names of exercises by what becomes of their files, and all that is written.
struct Brought {
    yours: Vec<&'static str>,
    workbooks: Vec<&'static str>,
    edited: Vec<&'static str>,
    /// The texts of files by their paths.
    files: BTreeMap<PathBuf, String>,
    manifest: Manifest,
}

impl Brought {
    /// The functions of all stages up to the last one in which an exercise of the core path is
    /// done: the texts that are `done`, by the names of their exercises, and the workbook's. Functions that open
    /// sheets ask for come, too, once they are done.
    fn new(
        folder: &Path,
        course: &[Exercise],
        done: &BTreeMap<&str, String>,
    ) -> Result<Self, String> {
        let is_done = |e: &&Exercise| e.is_core && done.contains_key(e.name);
        let Some(last) = course.iter().rfind(is_done) else {
            return Err(
                "no exercise of the core path is done; `cargo learn` shows the next".to_owned(),
            );
        };
        let mut stages: Vec<_> = course.iter().map(|e| e.stage).collect();
        stages.dedup();
        stages.retain(|stage| *stage <= last.stage);
        let mut functions = BEGINNING.to_owned();
        // Pixels need nothing but `common`.
        let libraries = &stages[1..];
        for stage in libraries {
            let library = stage.replace('-', "_");
            functions.extend(["pub use ", &library, "::*;\n"]);
        }
        let steps = sheet::steps()?;
        let mut brought = Self {
            yours: Vec::new(),
            workbooks: Vec::new(),
            edited: Vec::new(),
            files: BTreeMap::new(),
            manifest: Manifest::new(folder, libraries)?,
        };
        for e in course {
            let is_step = steps.iter().any(|step| step == e.name) && done.contains_key(e.name);
            let is_wanted = e.is_core || is_step;
            if !is_wanted || !stages.contains(&e.stage) || LEFT_OUT.contains(&e.name) {
                continue;
            }
            let workbooks = in_program(&files::read(&e.solution_file())?)?;
            let yours = done.get(e.name).map(|text| in_program(text)).transpose()?;
            let text = yours.as_ref().unwrap_or(&workbooks);
            functions += &module(e.name, text)?;
            let names = if !brought.add_unless_edited(folder, e.name, text, &workbooks)? {
                &mut brought.edited
            } else if yours.is_some() {
                &mut brought.yours
            } else {
                &mut brought.workbooks
            };
            names.push(e.name);
        }
        if stages.contains(&STAGE_OF_TRACER) {
            functions += &module("recursive_tracer", TRACER)?;
            brought.add_unless_edited(folder, "recursive_tracer", TRACER, TRACER)?;
        }
        let path = folder.join("src/functions.rs");
        if existing(&path)?.is_some_and(|now| !now.starts_with(FIRST_LINE.as_bytes())) {
            let path = text::path(&path);
            return Err(format!(
                "{path} is yours, and the functions would be written there; rename it"
            ));
        }
        brought.files.insert(path, functions);
        Ok(brought)
    }

    /// Adds the file of a function, and returns whether it has: one that is neither this text nor the
    /// workbook's has been edited there, and is left as it is.
    fn add_unless_edited(
        &mut self,
        folder: &Path,
        name: &str,
        text: &str,
        workbooks: &str,
    ) -> Result<bool, String> {
        let path = folder.join(format!("src/functions/{name}.rs"));
        if existing(&path)?.is_some_and(|now| now != text.as_bytes() && now != workbooks.as_bytes())
        {
            return Ok(false);
        }
        self.files.insert(path, text.to_owned());
        Ok(true)
    }

    fn write(&self) -> Result<(), String> {
        for (path, text) in &self.files {
            write(path, text)?;
        }
        self.manifest.write()
    }
}

/// The text of an exercise's file in the program: without the examples, which need the check.
fn in_program(text: &str) -> Result<String, String> {
    let text = tokens::replace(text, &|tokens| {
        if tokens::begin(tokens, &["testing", ":", ":", "examples", "!"]) {
            return Ok(Some((6, String::new())));
        }
        let is_prelude = tokens::begin(tokens, &["crate", ":", ":", "prelude"]);
        Ok(is_prelude.then(|| (4, "super".to_owned())))
    })?;
    Ok(text.trim_end().to_owned() + "\n")
}

/// The lines of `functions.rs` for a file: its public names replace those of the workbook.
fn module(name: &str, text: &str) -> Result<String, String> {
    let items = public_items(text)?.into_iter();
    let names: Vec<_> = items.map(|item| item.name).collect();
    let names = names.join(", ");
    Ok(format!("\nmod {name};\npub use {name}::{{{names}}};\n"))
}
