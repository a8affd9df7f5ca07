//! The exercises that are done, by name, in a file that no commit contains.

use std::fs;

use crate::exercise::Exercise;
use crate::files;

const FILE: &str = ".learn";

/// Length of a bar in characters.
const BAR: usize = 30;

/// Whether the last check found it done, and the student's file is still there.
pub fn is_done(exercise: &Exercise) -> bool {
    let done = files::read(FILE).unwrap_or_default();
    done.lines().any(|name| name == exercise.name) && files::saved(exercise).is_some()
}

/// How far the student is with it, in a word.
pub fn mark(exercise: &Exercise) -> &'static str {
    match (is_done(exercise), files::is_begun(exercise)) {
        (true, _) => "done",
        (_, true) => "begun",
        _ => "",
    }
}

/// Records the verdict of the last check.
pub fn record(exercise: &Exercise, is_done: bool) -> Result<(), String> {
    let known = files::read(FILE).unwrap_or_default();
    let others = known.lines().filter(|name| *name != exercise.name);
    let done = others.chain(is_done.then_some(exercise.name));
    let done: String = done.map(|name| [name, "\n"].concat()).collect();
    fs::write(files::shortest(FILE), done).map_err(files::failed(FILE.as_ref()))
}

/// The next open exercise: a later one on the same path as the `last`, or the first of the
/// core path, or the first of the others. None if all are done.
pub fn next<'a>(course: &'a [Exercise], last: Option<&Exercise>) -> Option<&'a Exercise> {
    let on_path = |is_core| move |e: &&Exercise| e.is_core == is_core;
    let later = course.iter().skip_while(|e| Some(*e) != last).skip(1);
    let later = later.filter(on_path(last.is_some_and(|e| e.is_core)));
    let core = course.iter().filter(on_path(true));
    later.chain(core).chain(course).find(|e| !is_done(e))
}

/// A bar for the core path and one for the further exercises.
pub fn bars(course: &[Exercise]) -> String {
    let bar = |words, is_core| {
        let path = course.iter().filter(|e| e.is_core == is_core);
        let (done, all) = (path.clone().filter(|e| is_done(e)).count(), path.count());
        let full = "#".repeat(BAR * done / all.max(1));
        format!("{words} [{full:.<BAR$}] {done} of {all}")
    };
    format!("{}\n{}", bar("core path", true), bar("further  ", false))
}

/// All exercises, one a line.
pub fn list(course: &[Exercise]) -> String {
    let row = |e: &Exercise| {
        let mark = mark(e);
        let path = if e.is_core { "core" } else { "" };
        let (name, title, minutes) = (e.name, e.title, e.minutes);
        format!("  {mark:5}  {path:4}  {name:18} {title}, {minutes} minutes")
    };
    let mut lines = Vec::new();
    for exercises in course.chunk_by(|a, b| a.stage == b.stage) {
        lines.push(exercises[0].stage.to_owned());
        lines.extend(exercises.iter().map(row));
    }
    format!("{}\n\n{}", lines.join("\n"), bars(course))
}
