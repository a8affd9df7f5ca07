//! Exercises that no page of the book sets, as those of a lecturer: the comment at the beginning
//! of their file is the task, and the one of their check, after what it compares, the hints.

use std::collections::BTreeSet;
use std::fs;

use crate::exercise::Exercise;
use crate::files;

/// The exercises of a stage that are not among those of its page, by name.
pub fn others(stage: &'static str, page: &[Exercise]) -> Result<Vec<Exercise>, String> {
    let mut paths = BTreeSet::new();
    for folder in ["starters", "solutions"].map(|folder| format!("{stage}/exercises/{folder}")) {
        let files = fs::read_dir(files::shortest(&folder)).into_iter().flatten();
        let names = files.filter_map(|file| file.ok()?.file_name().into_string().ok());
        paths.extend(names.map(|name| format!("{folder}/{name}")));
    }
    let name = |path: &str| Some(path.strip_suffix(".rs")?.rsplit_once('/')?.1.to_owned());
    let mut others = Vec::new();
    for path in paths {
        let name = name(&path).filter(|name| page.iter().all(|e| e.name != name));
        if let Some(name) = name {
            others.push(exercise(stage, name.leak(), path)?);
        }
    }
    Ok(others)
}

fn exercise(stage: &'static str, name: &'static str, path: String) -> Result<Exercise, String> {
    let check = format!("{stage}/tests/exercises/{name}.rs");
    let (task, hints) = (comment(&path)?, comment(&check)?);
    let parts = || {
        let (head, task) = task.split_once("\n\n")?;
        let (title, minutes) = head.strip_suffix(" minutes")?.rsplit_once(", ")?;
        Some((title.to_owned(), minutes.parse().ok()?, task.to_owned()))
    };
    let (title, minutes, task) =
        parts().ok_or_else(|| format!("{path}: it begins with no title, minutes and task"))?;
    let hints = hints.split("\n\n").skip(1);
    let solution = if path.contains("/solutions/") {
        path
    } else {
        check
    };
    Ok(Exercise {
        name,
        stage,
        title: title.leak(),
        minutes,
        is_core: false,
        task,
        hints: hints.map(|hint| format!("\n{hint}\n")).collect(),
        solution: solution.leak(),
    })
}

/// The comment at the beginning of a file.
fn comment(path: &str) -> Result<String, String> {
    let text = files::read(path)?;
    let lines = text.lines().map_while(|line| line.strip_prefix("//!"));
    let lines: Vec<_> = lines.map(str::trim).collect();
    Ok(lines.join("\n"))
}
