//! The student's file of an exercise, which begins as a copy of the starter.

use std::path::PathBuf;
use std::{fs, io};

use crate::exercise::Exercise;

pub fn yours(exercise: &Exercise) -> PathBuf {
    format!("{}/exercises/{}.rs", exercise.stage, exercise.name).into()
}

/// The text of the starter: a file of its own, or the solution without its code.
pub fn starter(exercise: &Exercise) -> Result<String, String> {
    let (stage, name) = (exercise.stage, exercise.name);
    let own = format!("{stage}/exercises/starters/{name}.rs");
    if let Ok(text) = fs::read_to_string(own) {
        return Ok(text);
    }
    let solution = format!("{stage}/exercises/solutions/{name}.rs");
    let text = fs::read_to_string(&solution).map_err(|error| format!("{solution}: {error}"))?;
    Ok(without_code(&text))
}

/// Leaves out the code of each `missing!("what", for_now, {`, which ends with a line `})`.
fn without_code(solution: &str) -> String {
    let mut starter = String::new();
    let mut lines = solution.lines();
    while let Some(line) = lines.next() {
        let head = line
            .strip_suffix(", {")
            .and_then(|head| head.split_once("missing!("));
        if let Some((before, arguments)) = head {
            let indent = &line[..line.len() - line.trim_start().len()];
            let end = format!("{indent}}})");
            let rest = lines
                .find_map(|line| line.strip_prefix(&end))
                .unwrap_or_default();
            starter += &[before, "testing::missing(", arguments, ")", rest, "\n"].concat();
        } else {
            starter += &[line, "\n"].concat();
        }
    }
    starter
}

/// Whether the student has changed the file.
pub fn is_begun(exercise: &Exercise) -> bool {
    let yours = fs::read_to_string(yours(exercise));
    yours.is_ok_and(|yours| starter(exercise) != Ok(yours))
}

/// Writes the starter, if the student has no file yet.
pub fn begin(exercise: &Exercise) -> Result<(), String> {
    let yours = yours(exercise);
    if !yours.exists() {
        let written = fs::write(&yours, starter(exercise)?);
        written.map_err(|error| format!("{}: {error}", yours.display()))?;
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
