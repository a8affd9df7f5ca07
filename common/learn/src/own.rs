//! Exercises that no page of the book sets, such as those of a lecturer.
//!
//! The comment at the beginning of the exercise's file has its title, minutes and task. The comment
//! of its check says in the first paragraph what is compared; the further ones are the hints.

use std::collections::BTreeMap;
use std::fs;

use crate::exercise::Exercise;
use crate::files;

/// The exercises of a stage that are not among those of its page, by name.
pub fn others(stage: &'static str, page: &[Exercise]) -> Result<Vec<Exercise>, String> {
    let mut paths = BTreeMap::new();
    for folder in ["solutions", "starters", files::OPEN] {
        let folder = format!("{stage}/exercises/{folder}");
        for name in names_in(&folder) {
            if page.iter().all(|e| e.name != name) {
                let path = format!("{folder}/{name}.rs");
                paths.insert(name, path);
            }
        }
    }
    let mut exercises = Vec::new();
    for (name, path) in paths {
        exercises.push(read_exercise(stage, name.leak(), &path)?);
    }
    Ok(exercises)
}

/// The names of the Rust files in a folder, which need not be there. The files that an editor
/// leaves beside them begin with a dot or end otherwise.
fn names_in(folder: &str) -> Vec<String> {
    let mut names = Vec::new();
    for entry in fs::read_dir(files::shortest(folder))
        .into_iter()
        .flatten()
        .flatten()
    {
        let file = entry.file_name();
        let name = file.to_str().and_then(|file| file.strip_suffix(".rs"));
        if let Some(name) = name.filter(|name| !name.starts_with('.')) {
            names.push(name.to_owned());
        }
    }
    names
}

fn read_exercise(stage: &'static str, name: &'static str, path: &str) -> Result<Exercise, String> {
    let check = format!("{stage}/tests/exercises/{name}.rs");
    let comment = read_comment(path)?.leak();
    let Some((title, minutes, task)) = split_task(comment) else {
        return Err(format!("{path}: it begins with no title, minutes and task"));
    };
    let mut hints = Vec::new();
    for hint in read_comment(&check)?.split("\n\n").skip(1) {
        hints.push(format!("\n{hint}\n"));
    }
    // The solution of a starter is in its check. The other one may be missing.
    let solution = if path.contains("/starters/") {
        check
    } else {
        format!("{stage}/exercises/solutions/{name}.rs")
    };
    Ok(Exercise {
        name,
        stage,
        title,
        minutes,
        is_core: false,
        task: task.to_owned(),
        hints,
        solution: solution.leak(),
    })
}

/// Title, minutes and task of a comment that begins such as `A camera for a dome, 20 minutes`.
fn split_task(comment: &str) -> Option<(&str, &str, &str)> {
    let (heading, task) = comment.split_once(" minutes\n\n")?;
    let (title, minutes) = heading.rsplit_once(", ")?;
    Some((title, minutes, task))
}

/// The comment at the beginning of a file.
fn read_comment(path: &str) -> Result<String, String> {
    let text = files::read(path)?;
    let mut lines = Vec::new();
    for line in text.lines() {
        let Some(words) = line.strip_prefix("//!") else {
            break;
        };
        lines.push(words.trim());
    }
    Ok(lines.join("\n"))
}
