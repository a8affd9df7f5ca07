//! `Exercise`: what the book's pages say about the exercises.

use std::fs;
use std::path::Path;

/// The workspace.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The part of a page with the exercises in which the reader writes the tracer.
const CORE_PATH: &str = "Build along";

/// A section of a page. Its texts live as long as the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exercise {
    /// The name of its files, without `.rs`.
    pub name: &'static str,
    /// The crate that sets it.
    pub stage: &'static str,
    pub title: &'static str,
    pub minutes: u32,
    /// Whether it belongs to the core path.
    pub is_core: bool,
    /// The text before the command and the hints, without pictures.
    pub task: &'static str,
    pub hints: &'static [String],
    /// The file with the solution, or the lesson.
    pub solution: &'static str,
}

/// The exercises of all stages, in the order of the book.
pub struct Course {
    pub exercises: Vec<Exercise>,
}

impl Course {
    pub fn read() -> Result<Self, String> {
        let entries = fs::read_dir(ROOT).map_err(|error| format!("{ROOT}: {error}"))?;
        let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
        let mut stages: Vec<_> = names.filter(|name| name.starts_with("a0")).collect();
        stages.sort();
        let mut exercises = Vec::new();
        for stage in stages {
            let number = stage.split('-').next().unwrap_or_default();
            let page = Path::new(ROOT).join(format!("book/src/{number}-exercises.md"));
            let text = fs::read_to_string(&page)
                .map_err(|error| format!("{}: {error}", page.display()))?;
            let text = text.replace("\r\n", "\n").leak();
            let found = sections(stage.leak(), text);
            exercises.extend(found.map_err(|problem| format!("{}: {problem}", page.display()))?);
        }
        Ok(Self { exercises })
    }

    pub fn named(&self, name: &str) -> Result<Exercise, String> {
        let mut exercises = self.exercises.iter().copied();
        let found = exercises.find(|exercise| exercise.name == name);
        found.ok_or_else(|| format!("there is no exercise {name}"))
    }
}

/// The exercises of a page.
fn sections(stage: &'static str, page: &'static str) -> Result<Vec<Exercise>, String> {
    let mut exercises = Vec::new();
    for part in page.split("\n## ").skip(1) {
        let mut sections = part.split("\n### ");
        let is_core = sections.next().and_then(|part| part.lines().next()) == Some(CORE_PATH);
        for section in sections {
            let (title, text) = section.split_once('\n').unwrap_or((section, ""));
            exercises.push(exercise(stage, title, text, is_core).ok_or_else(|| {
                format!("\"{title}\" lacks its file, minutes, command, hint or solution")
            })?);
        }
    }
    Ok(exercises)
}

fn exercise(
    stage: &'static str,
    title: &'static str,
    text: &'static str,
    is_core: bool,
) -> Option<Exercise> {
    let (before, after) = text.split_once(" minutes")?;
    let minutes = before.rsplit(['*', ' ', '\n']).next()?.parse().ok()?;
    let file = format!("{stage}/exercises/");
    let (name, _) = after.split_once(&*file)?.1.split_once(".rs")?;
    let (head, _) = text.split_once(&format!("```text\ncargo learn {name}\n```"))?;
    let (_, task) = head.split_once("*\n\n")?;
    let (_, solution) = text.split_once("\nSolution: ")?;
    let is_text = |paragraph: &&str| !paragraph.starts_with("![") && !paragraph.starts_with('*');
    let task: Vec<_> = task.trim().split("\n\n").filter(is_text).collect();
    let hints: Option<Vec<_>> = text.split("<details>").skip(1).map(hint).collect();
    Some(Exercise {
        name,
        stage,
        title,
        minutes,
        is_core,
        task: task.join("\n\n").leak(),
        hints: hints.filter(|hints| !hints.is_empty())?.leak(),
        solution: solution.split([',', '\n']).next()?.trim(),
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
    use super::*;

    const PAGE: &str = "# Exercises

## Build along

### The square

*10 minutes, in
`a01/exercises/square.rs`*

Multiply x by itself.

![A square](square.png)

*The square*

```text
cargo learn square
```

<details>
<summary>Hint</summary>

Once.

</details>

Solution: the lesson.
";

    #[test]
    fn a_section_is_an_exercise() {
        let expected = Exercise {
            name: "square",
            stage: "a01",
            title: "The square",
            minutes: 10,
            is_core: true,
            task: "Multiply x by itself.",
            hints: vec!["\nHint\n\nOnce.\n".to_owned()].leak(),
            solution: "the lesson.",
        };
        assert_eq!(sections("a01", PAGE), Ok(vec![expected]));
    }

    #[test]
    fn a_section_that_lacks_something_is_named() {
        for lacking in [
            "10 minutes",
            "a01/exercises/",
            "cargo learn",
            "<details>",
            "Once.",
            "Solution",
        ] {
            let page = PAGE.replacen(lacking, "", 1).leak();
            assert!(
                sections("a01", page)
                    .unwrap_err()
                    .contains("\"The square\""),
                "{lacking}"
            );
        }
    }

    /// No test would compile it.
    #[test]
    fn hints_are_words_and_not_code() {
        for exercise in Course::read().unwrap().exercises {
            let has_code = exercise.hints.iter().any(|hint| hint.contains("```rust"));
            assert!(!has_code, "{}", exercise.name);
        }
    }

    #[test]
    fn every_page_has_its_starters_and_no_others() {
        let mut course = Course::read().unwrap();
        let named = |e: &Exercise| Path::new(e.stage).join("exercises/starters").join(e.name);
        let mut named: Vec<_> = course.exercises.iter().map(named).collect();
        let mut files = Vec::new();
        course.exercises.dedup_by_key(|exercise| exercise.stage);
        for exercise in &course.exercises {
            let folder = Path::new(exercise.stage).join("exercises/starters");
            for entry in fs::read_dir(Path::new(ROOT).join(&folder)).unwrap() {
                files.push(folder.join(entry.unwrap().path().file_stem().unwrap()));
            }
        }
        named.sort();
        files.sort();
        assert_eq!(named, files);
        let mut names: Vec<_> = named.iter().map(|path| path.file_name()).collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), files.len(), "names are unique");
    }
}
