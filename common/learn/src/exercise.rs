//! `Exercise`: a row of a stage's list `exercises/exercises.toml`.

use std::fs;
use std::sync::OnceLock;

use common::row::{self, Row};

use crate::files;

/// The list in the folder of a stage.
const LIST: &str = "exercises/exercises.toml";

/// The least Jaro similarity of a name that may have been meant.
const LIKE: f64 = 0.8;

/// An exercise. Its texts live as long as the program.
#[derive(Debug, PartialEq, Eq)]
pub struct Exercise {
    /// The name of its files, without `.rs`.
    pub name: &'static str,
    /// The crate that sets it.
    pub stage: &'static str,
    /// The heading of its task in the book.
    pub title: &'static str,
    /// How long it takes, in minutes.
    pub minutes: u32,
    /// What it teaches, for lecturers.
    pub teaches: &'static str,
    /// Whether it belongs to the core path, in which the reader writes the tracer.
    pub is_core: bool,
    /// The file with the solution: of a core exercise, the lesson.
    pub solution: &'static str,
    /// Words of help, from gentle to plain, without the lines of a solution.
    pub(crate) hints: Vec<&'static str>,
}

/// The exercises of all stages.
///
/// # Errors
///
/// Fails if a list cannot be read.
pub fn read_all() -> Result<&'static [Exercise], String> {
    static COURSE: OnceLock<Result<Vec<Exercise>, String>> = OnceLock::new();
    match COURSE.get_or_init(read_lists) {
        Ok(course) => Ok(course),
        Err(error) => Err(error.clone()),
    }
}

fn read_lists() -> Result<Vec<Exercise>, String> {
    let workspace = files::workspace();
    let mut stages = Vec::new();
    let entries = fs::read_dir(&workspace).map_err(files::with_path(&workspace))?;
    for entry in entries.flatten() {
        if entry.path().join(LIST).is_file() {
            stages.push(entry.file_name().to_string_lossy().into_owned());
        }
    }
    stages.sort();
    let mut course = Vec::new();
    for stage in stages {
        let stage: &'static str = stage.leak();
        let path = format!("{stage}/{LIST}");
        let text = files::read(&path)?;
        course.extend(read_list(stage, &path, &text)?);
    }
    Ok(course)
}

/// The exercises of a list.
fn read_list(stage: &'static str, path: &str, text: &str) -> Result<Vec<Exercise>, String> {
    row::read(path, text, |file| {
        let rows = file.rows("exercise")?;
        file.end()?;
        rows.iter().map(|row| read_row(stage, row)).collect()
    })
}

fn read_row(stage: &'static str, row: &Row) -> Result<Exercise, String> {
    let leak = |text: String| -> &'static str { text.leak() };
    let name = leak(row.get("name")?);
    let lesson = row.find("lesson")?;
    let solution = lesson.unwrap_or_else(|| format!("{stage}/exercises/solutions/{name}.rs"));
    let hints: Vec<String> = row.find("hints")?.unwrap_or_default();
    let exercise = Exercise {
        name,
        stage,
        title: leak(row.get("title")?),
        minutes: row.get("minutes")?,
        teaches: leak(row.find("teaches")?.unwrap_or_default()),
        is_core: row.find("core")?.unwrap_or_default(),
        solution: leak(solution),
        hints: hints.into_iter().map(leak).collect(),
    };
    row.end()?;
    Ok(exercise)
}

/// The exercise of this name, in small or capital letters, or of this file.
///
/// # Errors
///
/// Fails if there is none; the error is the nearest name, or those of a stage.
pub fn find(word: &str) -> Result<&'static Exercise, String> {
    if word.is_empty() {
        return Err(
            "a name is missing; names in a list have commas and no spaces between".to_owned(),
        );
    }
    let course = read_all()?;
    let word = word.to_lowercase().replace('\\', "/");
    let word = word.trim_end_matches('/').trim_end_matches(".rs");
    let name = word.rsplit('/').next().unwrap_or_default();
    let stage = format!("{:0>2}", name.trim_start_matches('a'));
    let is_of_stage = |e: &&Exercise| e.stage[1..3] == stage || e.stage == name;
    let of_stage: Vec<_> = course.iter().filter(is_of_stage).map(|e| e.name).collect();
    if !of_stage.is_empty() {
        return Err(format!(
            "the exercises of this stage are {}",
            of_stage.join(", ")
        ));
    }
    let nearness = |e: &&Exercise| strsim::jaro(e.name, name);
    let nearest = course
        .iter()
        .max_by(|a, b| nearness(a).total_cmp(&nearness(b)));
    match nearest {
        Some(e) if e.name == name => Ok(e),
        Some(e) if nearness(&e) > LIKE => Err(format!("the nearest is {}", e.name)),
        _ => Err("no name is like it; `cargo learn list` has all".to_owned()),
    }
}

/// Whether a paragraph is the words below a picture: one in italics, and not in bold.
fn is_caption(paragraph: &str) -> bool {
    paragraph.starts_with('*') && !paragraph.starts_with("**")
}

impl Exercise {
    /// The file with the task and the code that a starter lacks.
    #[must_use]
    pub fn solution_file(&self) -> String {
        format!("{}/exercises/solutions/{}.rs", self.stage, self.name)
    }

    /// The task: the section of the title in the book, up to the command, without pictures and the
    /// words below them. Without a section, the file's own comment is the task.
    pub(crate) fn task(&self) -> String {
        let page = format!("book/src/{}-exercises.md", &self.stage[..3]);
        let page = files::read(&page).unwrap_or_default().replace("\r\n", "\n");
        let heading = format!("\n### {}\n", self.title);
        let section = page.split_once(&heading).map_or("", |(_, section)| section);
        let task = section.split("```text\ncargo learn ").next();
        let mut paragraphs = Vec::new();
        for paragraph in task.unwrap_or_default().trim().split("\n\n") {
            if !paragraph.starts_with("![") && !is_caption(paragraph) {
                paragraphs.push(paragraph);
            }
        }
        paragraphs.join("\n\n")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_that_lacks_something_is_named() {
        let rows =
            "[[exercise]]\nname = \"a\"\ntitle = \"A\"\nminutes = 5\n[[exercise]]\nname = \"b\"\n";
        let error = read_list("a01", "list.toml", rows).unwrap_err();
        let lacks = "list.toml, exercise 2 (b): `title` is missing";
        assert!(error.starts_with(lacks), "{error}");
        assert!(find("spere").unwrap_err().ends_with("sphere"));
        let path = r"a04-intersections\exercises\Sphere.rs";
        assert_eq!(find(path).unwrap().name, "sphere");
        for (word, problem) in [("", "a name is missing"), ("stage", "no name is like it")] {
            assert!(find(word).unwrap_err().contains(problem), "{word}");
        }
        assert!(find("nosuch").unwrap_err().contains("no name is like it"));
        for stage in ["1", "01", "a1", "A01", "./a01-image-display/"] {
            let error = find(stage).unwrap_err();
            assert!(
                error.starts_with("the exercises of this stage are set_pixel,"),
                "{error}"
            );
        }
    }
}
