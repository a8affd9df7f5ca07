//! The student's file of an exercise, which begins as a copy of the starter.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::exercise::{Exercise, ROOT};

/// The student's file, relative to the workspace.
pub fn shown(exercise: Exercise) -> String {
    format!("{}/exercises/{}.rs", exercise.stage, exercise.name)
}

/// The student's file.
pub fn yours(exercise: Exercise) -> PathBuf {
    Path::new(ROOT).join(shown(exercise))
}

fn starter(exercise: Exercise) -> PathBuf {
    let file = format!("{}/exercises/starters/{}.rs", exercise.stage, exercise.name);
    Path::new(ROOT).join(file)
}

/// Whether the student has changed the file.
pub fn is_begun(exercise: Exercise) -> bool {
    let yours = fs::read(yours(exercise));
    yours.is_ok_and(|yours| fs::read(starter(exercise)).ok() != Some(yours))
}

/// Copies the starter, if the student has no file yet.
pub fn begin(exercise: Exercise) -> Result<(), String> {
    if yours(exercise).exists() {
        return Ok(());
    }
    copy(&starter(exercise), &yours(exercise))
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    let copied = fs::copy(from, to).map_err(|error| format!("{}: {error}", to.display()));
    copied.map(drop)
}

/// Asks, renames the student's file, and copies the starter.
pub fn reset(exercise: Exercise) -> Result<(), String> {
    let (file, yours) = (shown(exercise), yours(exercise));
    if !is_begun(exercise) {
        println!("{file} is the starter");
        return begin(exercise);
    }
    let mut backups = (1..).map(|number| yours.with_extension(format!("{number}.bak")));
    let backup = backups.find(|path| !path.exists()).unwrap_or_default();
    let kept = backup.file_name().unwrap_or_default().display();
    print!("Begin {file} anew? Your file is kept as {kept}. [y/N] ");
    let mut answer = String::new();
    let asked = io::stdout()
        .flush()
        .and_then(|()| io::stdin().read_line(&mut answer));
    asked.map_err(|error| error.to_string())?;
    if !answer.trim().eq_ignore_ascii_case("y") {
        println!("Nothing is changed.");
        return Ok(());
    }
    fs::rename(&yours, &backup).map_err(|error| format!("{file}: {error}"))?;
    begin(exercise)
}
