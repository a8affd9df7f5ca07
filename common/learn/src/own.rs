//! Exercises that no page of the book sets, such as those of a lecturer: the comment at the beginning
//! of their file is the task, and the one of their check, after what it compares, the hints.

use std::collections::BTreeMap;
use std::fs;

use crate::exercise::Exercise;
use crate::files;

/// The exercises of a stage that are not among those of its page, by name.
pub fn others(stage: &'static str, page: &[Exercise]) -> Result<Vec<Exercise>, String> {
    let mut paths = BTreeMap::new();
    for folder in ["solutions", "starters", files::OPEN] {
        let folder = format!("{stage}/exercises/{folder}");
        let entries = fs::read_dir(files::shortest(&folder)).into_iter().flatten();
        for file in entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok()) {
            let name = file.trim_end_matches(".rs");
            if page.iter().all(|e| e.name != name) {
                paths.insert(name.to_owned(), format!("{folder}/{file}"));
            }
        }
    }
    let read = |(name, path): (String, String)| exercise(stage, name.leak(), &path);
    paths.into_iter().map(read).collect()
}

fn exercise(stage: &'static str, name: &'static str, path: &str) -> Result<Exercise, String> {
    let check = format!("{stage}/tests/exercises/{name}.rs");
    let (task, hints) = (comment(path)?.leak(), comment(&check)?);
    let parts = task.split_once(" minutes\n\n");
    let parts = parts.and_then(|(head, task)| Some((head.rsplit_once(", ")?, task)));
    let ((title, minutes), task) =
        parts.ok_or_else(|| format!("{path}: it begins with no title, minutes and task"))?;
    let hints = hints.split("\n\n").skip(1);
    // It may be missing.
    let is_in_check = path.contains("/starters/");
    let solution = format!("{stage}/exercises/solutions/{name}.rs");
    Ok(Exercise {
        name,
        stage,
        title,
        minutes,
        is_core: false,
        task: task.to_owned(),
        hints: hints.map(|hint| format!("\n{hint}\n")).collect(),
        solution: if is_in_check { check } else { solution }.leak(),
    })
}

/// The comment at the beginning of a file.
fn comment(path: &str) -> Result<String, String> {
    let text = files::read(path)?;
    let lines = text.lines().map_while(|line| line.strip_prefix("//!"));
    Ok(lines.map(str::trim).collect::<Vec<_>>().join("\n"))
}
