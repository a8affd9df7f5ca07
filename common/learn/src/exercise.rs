//! `Exercise`: a section of the book's pages `aNN-exercises.md`, or a file with its own task.

use crate::{files, own, parsons_problem};

/// An exercise. Its texts live as long as the program.
#[derive(Debug, PartialEq, Eq)]
pub struct Exercise {
    /// The name of its files, without `.rs`.
    pub name: &'static str,
    /// The crate that sets it.
    pub stage: &'static str,
    pub title: &'static str,
    pub minutes: &'static str,
    /// Whether it belongs to the core path, in which the reader writes the tracer.
    pub is_core: bool,
    /// The text before the command, without pictures.
    pub task: String,
    pub hints: Vec<String>,
    /// The file with the solution, or the lesson.
    pub solution: &'static str,
}

/// The exercises of all stages: those of a page in its order, and then the others of the stage.
pub fn read_all() -> Result<&'static [Exercise], String> {
    let mut exercises = Vec::new();
    for stage in 1.. {
        let page = format!("book/src/a{stage:02}-exercises.md");
        if !files::shortest(&page).exists() {
            break;
        }
        let text = files::read(&page)?.replace("\r\n", "\n").leak();
        let mut of_stage = read_sections(text).map_err(|problem| format!("{page}: {problem}"))?;
        let stage = of_stage.first().map_or("", |e| e.stage);
        for e in of_stage.iter_mut().filter(|e| e.is_core) {
            parsons_problem::add_first_hint(e);
        }
        of_stage.append(&mut own::others(stage, &of_stage)?);
        exercises.append(&mut of_stage);
    }
    Ok(exercises.leak())
}

/// The exercise of this name. The error is the nearest name.
pub fn find(name: &str) -> Result<&'static Exercise, String> {
    let mut nearest = None;
    let mut largest_nearness = 0.0;
    for e in read_all()? {
        if e.name == name {
            return Ok(e);
        }
        let nearness = strsim::jaro(e.name, name);
        if nearness > largest_nearness {
            largest_nearness = nearness;
            nearest = Some(e);
        }
    }
    Err(match nearest {
        Some(e) => format!("the nearest is {}", e.name),
        None => "no name is like it".to_owned(),
    })
}

/// The exercises of a page.
fn read_sections(page: &'static str) -> Result<Vec<Exercise>, String> {
    let mut exercises = Vec::new();
    for part in page.split("\n## ").skip(1) {
        let is_core = part.starts_with("Build along\n");
        for section in part.split("\n### ").skip(1) {
            let Some(exercise) = read_section(section, is_core) else {
                let title = section.lines().next().unwrap_or_default();
                return Err(format!(
                    "\"{title}\" lacks its minutes, file, task, command, hint or solution"
                ));
            };
            exercises.push(exercise);
        }
    }
    Ok(exercises)
}

/// Takes a section apart, from its title to its solution.
fn read_section(section: &'static str, is_core: bool) -> Option<Exercise> {
    let (title, rest) = section.split_once("\n\n*")?;
    let (minutes, rest) = rest.split_once(" minutes, in\n`")?;
    let (file, rest) = rest.split_once(".rs`*\n\n")?;
    let (stage, name) = file.split_once("/exercises/")?;
    let (task, rest) = rest.split_once(&format!("```text\ncargo learn {name}\n```\n"))?;
    let (details, solution) = rest.split_once("\nSolution: ")?;

    let mut paragraphs = Vec::new();
    for paragraph in task.trim().split("\n\n") {
        // Neither a picture nor the words below it.
        if !paragraph.starts_with("![") && !paragraph.starts_with('*') {
            paragraphs.push(paragraph);
        }
    }
    let mut hints = Vec::new();
    for hint in details.split("<summary>").skip(1) {
        hints.push(read_hint(hint)?);
    }
    if hints.is_empty() {
        return None;
    }
    Some(Exercise {
        name,
        stage,
        title,
        minutes,
        is_core,
        task: paragraphs.join("\n\n"),
        hints,
        solution: solution.split('`').nth(1)?,
    })
}

/// The summary of a hint and its text.
fn read_hint(details: &str) -> Option<String> {
    let (summary, text) = details.split_once("</summary>")?;
    let (text, _) = text.split_once("</details>")?;
    let text = text.trim();
    if text.is_empty() {
        return None;
    }
    Some(format!("\n{summary}\n\n{text}\n"))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    /// Each exercise has its files; starters lack something, and those of the core path name its
    /// steps; hints are words, as no test would compile code in them; and the checks of the core path
    /// accept another style.
    #[test]
    fn exercises_have_their_files() {
        let mut names = BTreeSet::new();
        for e in read_all().unwrap() {
            let (name, starter) = (e.name, files::starter(e).unwrap());
            assert!(names.insert(name), "{name} is the name of two exercises");
            assert!(e.minutes.parse::<u32>().is_ok(), "{name}: its minutes");
            for part in ["testing::missing(", "testing::examples!"] {
                assert!(starter.contains(part), "{name}: {part}");
            }
            if e.is_core {
                let parts = starter.matches("testing::missing(").count();
                let [first, second] =
                    ["// 1. ", "// 2. "].map(|number| starter.matches(number).count());
                assert_eq!(
                    [first, second],
                    [parts; 2],
                    "{name}: the steps of each part"
                );
            }
            assert!(!starter.contains("missing!("), "{name}");
            let count = |brace| starter.matches(brace).count();
            assert_eq!(count('{'), count('}'), "{name}");
            assert!(!e.hints.concat().contains("```rust"), "{name}");
            let open = format!("{}/exercises/{}/{name}.rs", e.stage, files::OPEN);
            let mut files = [e.solution, &open].map(files::shortest).into_iter();
            assert!(files.any(|file| file.exists()), "{name}");
            let answers = format!("{}/exercises/answers/{name}.txt", e.stage);
            assert!(files::shortest(&answers).exists(), "{name}");
            let check = files::read(&format!("{}/tests/exercises/{name}.rs", e.stage)).unwrap();
            assert!(!e.is_core || check.contains("right: vec!["), "{name}");
        }
    }

    /// The page shows what the check paints: what this code alone draws, or the scene of the stage.
    #[test]
    fn each_core_exercise_shows_another_picture() {
        let mut pictures = BTreeSet::new();
        for e in read_all().unwrap().iter().filter(|e| e.is_core) {
            let (stage, name) = (e.stage, e.name);
            let page = files::read(&format!("book/src/{}-exercises.md", &stage[..3])).unwrap();
            let command = format!("cargo learn {name}\n");
            let (before, _) = page.split_once(&command).unwrap();
            let (_, section) = before.rsplit_once("\n### ").unwrap();
            let (_, shown) = section.split_once("](pictures/").expect(name);
            let (shown, _) = shown.split_once(')').unwrap();

            let check = files::read(&format!("{stage}/tests/exercises/{name}.rs")).unwrap();
            let answers = files::read(&format!("{stage}/exercises/answers/{name}.txt")).unwrap();
            let scene = answers
                .lines()
                .find_map(|line| line.strip_prefix("picture "));
            let painted = if check.contains("drawing: drawing(") {
                format!("{stage}-exercise-{}.png", name.replace('_', "-"))
            } else {
                format!("{stage}-{}.png", scene.expect(name))
            };
            assert_eq!(shown, painted, "{name}");
            assert!(
                pictures.insert(painted),
                "{name}: another exercise shows it"
            );
        }
    }
}
