//! `Exercise`: a section of the book's pages `aNN-exercises.md`.

use std::fs;

/// Number of stages; each has a page.
const STAGES: u32 = 7;

/// A section of a page. Its texts live as long as the program.
#[derive(Debug, PartialEq, Eq)]
pub struct Exercise {
    /// The name of its files, without `.rs`.
    pub name: &'static str,
    /// The crate that sets it.
    pub stage: &'static str,
    pub title: &'static str,
    pub minutes: u32,
    /// Whether it belongs to the core path, in which the reader writes the tracer.
    pub is_core: bool,
    /// The text before the command, without pictures.
    pub task: String,
    pub hints: Vec<String>,
    /// The file with the solution, or the lesson.
    pub solution: &'static str,
}

/// The exercises of all stages, in the order of the book.
pub fn read_all() -> Result<Vec<Exercise>, String> {
    let mut exercises = Vec::new();
    for stage in 1..=STAGES {
        let page = format!("book/src/a{stage:02}-exercises.md");
        let text = fs::read_to_string(&page).map_err(|error| format!("{page}: {error}"))?;
        let text = text.replace("\r\n", "\n").leak();
        exercises.extend(sections(text).map_err(|problem| format!("{page}: {problem}"))?);
    }
    Ok(exercises)
}

/// The exercises of a page.
fn sections(page: &'static str) -> Result<Vec<Exercise>, String> {
    let mut exercises = Vec::new();
    for part in page.split("\n## ").skip(1) {
        let is_core = part.starts_with("Build along\n");
        for section in part.split("\n### ").skip(1) {
            exercises.push(exercise(section, is_core).ok_or_else(|| {
                let title = section.lines().next().unwrap_or_default();
                format!("\"{title}\" lacks its minutes, file, task, command, hint or solution")
            })?);
        }
    }
    Ok(exercises)
}

/// Takes a section apart, from its title to its solution.
fn exercise(section: &'static str, is_core: bool) -> Option<Exercise> {
    let (title, rest) = section.split_once("\n\n*")?;
    let (minutes, rest) = rest.split_once(" minutes, in\n`")?;
    let (file, rest) = rest.split_once(".rs`*\n\n")?;
    let (stage, name) = file.split_once("/exercises/")?;
    let (task, rest) = rest.split_once(&format!("```text\ncargo learn {name}\n```\n"))?;
    let (hints, solution) = rest.split_once("\nSolution: ")?;

    let is_text = |paragraph: &&str| !paragraph.starts_with("![") && !paragraph.starts_with('*');
    let task: Vec<_> = task.trim().split("\n\n").filter(is_text).collect();
    let hints: Option<Vec<_>> = hints.split("<details>").skip(1).map(hint).collect();
    Some(Exercise {
        name,
        stage,
        title,
        minutes: minutes.parse().ok()?,
        is_core,
        task: task.join("\n\n"),
        hints: hints.filter(|hints| !hints.is_empty())?,
        solution: solution.split([',', '\n']).next()?,
    })
}

/// The summary of a hint and its text.
fn hint(details: &str) -> Option<String> {
    let (summary, text) = details.split_once("</summary>")?;
    let (_, summary) = summary.split_once("<summary>")?;
    let (text, _) = text.split_once("</details>")?;
    let text = text.trim();
    (!text.is_empty()).then(|| format!("\n{summary}\n\n{text}\n"))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::PathBuf;

    use super::*;
    use crate::{enter_workspace, files};

    #[test]
    fn every_page_has_its_solutions_and_no_others() {
        enter_workspace().unwrap();
        let exercises = read_all().unwrap();
        let names: BTreeSet<_> = exercises.iter().map(|e| e.name).collect();
        assert_eq!(names.len(), exercises.len(), "names are unique");

        let stages: BTreeSet<_> = exercises.iter().map(|e| e.stage).collect();
        let folders = stages
            .iter()
            .map(|stage| format!("{stage}/exercises/solutions"));
        let found: BTreeSet<_> = folders
            .flat_map(|folder| fs::read_dir(folder).unwrap())
            .map(|entry| entry.unwrap().path())
            .collect();
        let solution = |e: &Exercise| format!("{}/exercises/solutions/{}.rs", e.stage, e.name);
        let named: BTreeSet<PathBuf> = exercises.iter().map(|e| solution(e).into()).collect();
        assert_eq!(named, found);
    }

    /// Code in hints would be compiled by no test.
    #[test]
    fn starters_lack_something_and_hints_are_words() {
        enter_workspace().unwrap();
        for exercise in read_all().unwrap() {
            let (starter, name) = (files::starter(&exercise).unwrap(), exercise.name);
            for part in ["testing::missing(", "testing::examples!"] {
                assert!(starter.contains(part), "{name}: {part}");
            }
            assert!(!starter.contains("missing!("), "{name}");
            let hints = exercise.hints.concat();
            assert!(!hints.is_empty() && !hints.contains("```rust"), "{name}");
        }
    }

    /// The core path has a right solution in another style.
    #[test]
    fn checks_of_the_core_path_accept_another_style() {
        enter_workspace().unwrap();
        for exercise in read_all().unwrap().iter().filter(|e| e.is_core) {
            let check = format!("{}/tests/exercises/{}.rs", exercise.stage, exercise.name);
            let has_other = fs::read_to_string(&check).unwrap().contains("    right(");
            assert!(has_other, "{check}");
        }
    }
}
