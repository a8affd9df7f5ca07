//! The exercises that are done, in a file of the workspace that no commit contains.

use std::fs;
use std::path::{Path, PathBuf};

use crate::exercise::{Course, Exercise, ROOT};
use crate::files;

/// Length of a bar in characters.
const BAR: usize = 30;

fn file() -> PathBuf {
    Path::new(ROOT).join(".learn")
}

/// The names of the exercises that are done.
fn done() -> Vec<String> {
    let text = fs::read_to_string(file()).unwrap_or_default();
    text.lines().map(str::to_owned).collect()
}

pub fn is_done(exercise: Exercise) -> bool {
    done().iter().any(|name| name == exercise.name)
}

/// Records that an exercise is done.
pub fn record(exercise: Exercise) -> Result<(), String> {
    if is_done(exercise) {
        return Ok(());
    }
    let text = format!(
        "{}\n",
        [done(), vec![exercise.name.to_owned()]].concat().join("\n")
    );
    fs::write(file(), text).map_err(|error| format!("{}: {error}", file().display()))
}

/// The next exercise that is not done: first those of the core path.
pub fn next(course: &Course) -> Result<Exercise, String> {
    let open = |core| move |e: &Exercise| e.is_core == core && !is_done(*e);
    let exercises = || course.exercises.iter().copied();
    let next = exercises()
        .find(open(true))
        .or_else(|| exercises().find(open(false)));
    next.ok_or_else(|| "all exercises are done".to_owned())
}

/// A bar for the core path and one for the further exercises.
pub fn bars(course: &Course) -> String {
    let bar = |words: &str, core: bool| {
        let all: Vec<_> = course
            .exercises
            .iter()
            .filter(|e| e.is_core == core)
            .collect();
        let done = all.iter().filter(|e| is_done(***e)).count();
        let full = BAR * done / all.len().max(1);
        let (full, empty) = ("#".repeat(full), ".".repeat(BAR - full));
        format!("{words} [{full}{empty}] {done} of {}", all.len())
    };
    format!("{}\n{}", bar("core path", true), bar("further  ", false))
}

/// Prints all exercises.
pub fn list(course: &Course) {
    for exercises in course.exercises.chunk_by(|a, b| a.stage == b.stage) {
        println!("{}", exercises[0].stage);
        for exercise in exercises {
            let mark = match (is_done(*exercise), files::is_begun(*exercise)) {
                (true, _) => "done ",
                (_, true) => "begun",
                _ => "     ",
            };
            let path = if exercise.is_core { "core" } else { "    " };
            let Exercise {
                name,
                title,
                minutes,
                ..
            } = exercise;
            println!("  {mark}  {path}  {name:18} {title}, {minutes} minutes");
        }
    }
    println!("\n{}", bars(course));
}
