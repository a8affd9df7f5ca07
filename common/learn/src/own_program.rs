//! `own_program`: brings the functions of exercises into a program of the student's, outside of the workbook.
//!
//! The student has made the program by `cargo new`, and its `main.rs` is theirs: nothing here writes it.
//! Its file `functions.rs` is written anew each time; a file in `functions` only as long as the student has
//! not edited it there.

mod manifest;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use common::text;

use crate::exercise::Exercise;
use crate::files::{self, with_path};
use crate::progress::Progress;
use crate::public_items::public_items;
use crate::screen::Screen;
use crate::{sheet, tokens};
pub use manifest::MANIFEST;

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
        let shown = text::path(folder);
        if !folder.join(MANIFEST).is_file() {
            return Err(format!(
                "{shown} has no {MANIFEST}: `cargo new {shown}` begins a program, and this brings your functions into it"
            ));
        }
        let progress = Progress::read();
        let mut done = BTreeMap::new();
        for e in course.iter().filter(|e| progress.is_done(e)) {
            done.insert(e.name, files::text_of(&files::yours(e))?);
        }
        let brought = bring(folder, course, &done)?;
        let mut lines = vec![format!("{shown}: your {}", brought.yours.join(", "))];
        for (words, names) in [
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
        if brought.has_new_libraries {
            let words =
                "its Cargo.toml has new libraries: the next build takes about half a minute";
            lines.push(words.to_owned());
        }
        Ok(Screen::new().wrap(&lines.join("\n")))
    }
}

/// What is brought: the names of exercises by what has become of their files.
#[derive(Default)]
struct Brought {
    yours: Vec<&'static str>,
    workbooks: Vec<&'static str>,
    edited: Vec<&'static str>,
    /// Whether the next build compiles libraries.
    has_new_libraries: bool,
}

/// Writes the functions of all stages up to the last one in which an exercise of the core path is
/// done: the texts that are `done`, by the names of their exercises, and the workbook's. Functions that open
/// sheets ask for come, too, once they are done.
fn bring(
    folder: &Path,
    course: &[Exercise],
    done: &BTreeMap<&str, String>,
) -> Result<Brought, String> {
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
    let mut brought = Brought::default();
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
        let names = if !write_unless_edited(folder, e.name, text, &workbooks)? {
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
        write_unless_edited(folder, "recursive_tracer", TRACER, TRACER)?;
    }
    let path = folder.join("src/functions.rs");
    if fs::read_to_string(&path).is_ok_and(|text| !text.starts_with(FIRST_LINE)) {
        let path = text::path(&path);
        return Err(format!(
            "{path} is yours, and the functions would be written there; rename it"
        ));
    }
    write(&path, &functions)?;
    brought.has_new_libraries = manifest::complete(folder, libraries)?;
    Ok(brought)
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

/// Writes a file of a function, and returns whether it has: one that is neither this text nor the
/// workbook's has been edited there, and is left as it is.
fn write_unless_edited(
    folder: &Path,
    name: &str,
    text: &str,
    workbooks: &str,
) -> Result<bool, String> {
    let path = folder.join(format!("src/functions/{name}.rs"));
    let now = fs::read_to_string(&path);
    if now.is_ok_and(|now| now != text && now != workbooks) {
        return Ok(false);
    }
    write(&path, text)?;
    Ok(true)
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(with_path(folder))?;
    }
    fs::write(path, text).map_err(with_path(path))
}
