//! Exercises that no page of the book sets, as those of a lecturer: the comment at the beginning
//! of their file is the task, and the one of their check, after what it compares, the hints.

use std::fs;

use crate::exercise::Exercise;
use crate::files;

/// The exercises of a stage that are not among those of its page.
pub fn others(stage: &'static str, page: &[Exercise]) -> Result<Vec<Exercise>, String> {
    let mut others = Vec::new();
    for folder in ["starters", "solutions"] {
        let folder = format!("{stage}/exercises/{folder}");
        let entries = fs::read_dir(files::shortest(&folder)).into_iter().flatten();
        let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
        let mut names: Vec<_> = names.collect();
        names.sort();
        for file in names {
            let name = file.trim_end_matches(".rs");
            if page.iter().chain(&others).all(|e| e.name != name) {
                others.push(exercise(stage, &folder, name.to_owned().leak())?);
            }
        }
    }
    Ok(others)
}

fn exercise(stage: &'static str, folder: &str, name: &'static str) -> Result<Exercise, String> {
    let path = format!("{folder}/{name}.rs");
    let check = format!("{stage}/tests/exercises/{name}.rs");
    let (task, hints) = (comment(&path)?, comment(&check)?);
    let (title, minutes, task) =
        parts(&task).ok_or_else(|| format!("{path}: it begins with no title, minutes and task"))?;
    let is_solution = folder.ends_with("/solutions");
    Ok(Exercise {
        name,
        stage,
        title: title.to_owned().leak(),
        minutes,
        is_core: false,
        task: task.to_owned(),
        hints: hints
            .split("\n\n")
            .skip(1)
            .map(|hint| format!("\n{hint}\n"))
            .collect(),
        solution: if is_solution { path } else { check }.leak(),
    })
}

/// Title, minutes and task.
fn parts(comment: &str) -> Option<(&str, u32, &str)> {
    let (head, task) = comment.split_once(" minutes\n\n")?;
    let (title, minutes) = head.rsplit_once(", ")?;
    Some((title, minutes.parse().ok()?, task))
}

/// The comment at the beginning of a file.
fn comment(path: &str) -> Result<String, String> {
    let text = files::read(path)?;
    let lines = text.lines().map_while(|line| line.strip_prefix("//!"));
    Ok(lines.map(str::trim).collect::<Vec<_>>().join("\n"))
}
