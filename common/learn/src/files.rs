//! The student's file of an exercise, which begins as a copy of the starter.

use std::path::PathBuf;
use std::{fs, io};

use crate::exercise::Exercise;

pub fn yours(exercise: &Exercise) -> PathBuf {
    format!("{}/exercises/{}.rs", exercise.stage, exercise.name).into()
}

pub fn starter(exercise: &Exercise) -> PathBuf {
    format!("{}/exercises/starters/{}.rs", exercise.stage, exercise.name).into()
}

/// Whether the student has changed the file.
pub fn is_begun(exercise: &Exercise) -> bool {
    let yours = fs::read(yours(exercise));
    yours.is_ok_and(|yours| fs::read(starter(exercise)).ok() != Some(yours))
}

/// Copies the starter, if the student has no file yet.
pub fn begin(exercise: &Exercise) -> Result<(), String> {
    let yours = yours(exercise);
    if !yours.exists() {
        let copied = fs::copy(starter(exercise), &yours);
        copied.map_err(|error| format!("{}: {error}", yours.display()))?;
    }
    Ok(())
}

/// Asks, renames the student's file, and copies the starter.
pub fn reset(exercise: &Exercise) -> Result<(), String> {
    let yours = yours(exercise);
    let file = yours.display();
    if !is_begun(exercise) {
        println!("{file} is the starter");
        return begin(exercise);
    }
    let mut names = (1..).map(|number| format!("{}.{number}.bak", exercise.name));
    let is_free = |name: &String| !yours.with_file_name(name).exists();
    let backup = names.find(is_free).unwrap_or_default();
    // Not `print`, which keeps a line until it ends.
    eprint!("Begin {file} anew? Your file is kept as {backup}. [y/N] ");
    let mut answer = String::new();
    let read = io::stdin().read_line(&mut answer);
    read.map_err(|error| error.to_string())?;
    if !answer.trim().eq_ignore_ascii_case("y") {
        println!("Nothing is changed.");
        return Ok(());
    }
    let renamed = fs::rename(&yours, yours.with_file_name(backup));
    renamed.map_err(|error| format!("{file}: {error}"))?;
    begin(exercise)
}
