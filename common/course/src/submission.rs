//! The file of an exercise in a student's hand-in: the one that has its name, such as `sphere.rs`, in any folder.

#[cfg(test)]
mod tests;

use learn::exercise::Exercise;

use crate::handed_file::{Content, HandedFile, SHEETS, is_brought, may_be_rust};

/// Folders of the workbook, beside those of the stages, around files that have the names of exercises.
const OF_WORKBOOK: [&str; 3] = ["book", "common", "exercises"];

/// Folders in them whose files are the workbook's, and no student's.
const NOT_STUDENTS: [&str; 8] = [
    "answers",
    "benches",
    "examples",
    "others",
    "questions",
    "solutions",
    "src",
    "tests",
];

/// The most names in a message.
const MAX_NAMES: usize = 10;

/// A student's file of an exercise.
#[derive(Clone, Copy)]
pub struct StudentFile<'a> {
    pub exercise: &'static Exercise,
    pub text: &'a str,
}

/// The file of an exercise in a hand-in.
#[derive(Debug, PartialEq, Eq)]
pub enum Found<'a> {
    File {
        path: String,
        text: &'a str,
    },
    Nothing,
    /// Nobody can tell without a look; why, in words for the student.
    Unclear(String),
}

/// The files that a student has handed in, without those of the workbook around them, and those that
/// `cargo learn program` has brought.
pub struct Submission<'a> {
    course: &'static [Exercise],
    files: Vec<&'a HandedFile>,
    /// The folders of programs for sheets.
    programs: Vec<&'a [String]>,
}

impl<'a> Submission<'a> {
    pub fn new(files: &'a [HandedFile], course: &'static [Exercise]) -> Self {
        let is_stage = |folder: &str| course.iter().any(|e| e.stage == folder);
        let is_sheet = |file: &&HandedFile| file.name() == SHEETS;
        let programs: Vec<_> = files
            .iter()
            .filter(is_sheet)
            .map(HandedFile::folder)
            .collect();
        let is_own = |file: &&HandedFile| {
            if in_program(&programs, file).is_some_and(|path| is_brought(&path)) {
                return false;
            }
            let mut inner = file.folders().iter();
            let is_around = |folder: &String| OF_WORKBOOK.contains(&&**folder) || is_stage(folder);
            let is_workbooks = |folder: &String| NOT_STUDENTS.contains(&&**folder);
            file.name() != "build.rs" && !(inner.any(is_around) && inner.any(is_workbooks))
        };
        let files = files.iter().filter(is_own).collect();
        Self {
            course,
            files,
            programs,
        }
    }

    /// The file of an exercise. Of two that differ nobody knows which one counts.
    pub fn find(&self, e: &Exercise) -> Found<'a> {
        let mut found: Vec<&HandedFile> = Vec::new();
        for file in &self.files {
            if is_of(file, e) && !found.iter().any(|other| other.content == file.content) {
                found.push(file);
            }
        }
        match found[..] {
            [] => self.without_file(),
            [file] => match &file.content {
                Content::Text(text) => Found::File {
                    path: file.path_text(),
                    text,
                },
                Content::Problem(problem) => {
                    Found::Unclear(format!("{}: {problem}", file.path_text()))
                }
                Content::Bytes(_) | Content::LeftOut(_) => {
                    Found::Unclear(format!("{}: it is no text", file.path_text()))
                }
            },
            [_, _, ..] => {
                let count = found.len();
                let names = names(found.iter().map(|file| file.path_text()));
                Found::Unclear(format!("there are {count} files: {names}; hand in one"))
            }
        }
    }

    /// Whether an exercise without a file is not handed in, or there are files that may be it.
    fn without_file(&self) -> Found<'a> {
        let is_exercise = |file: &HandedFile| self.course.iter().any(|e| is_of(file, e));
        let has_exercises = self.files.iter().any(|file| is_exercise(file));
        let has_others = has_exercises || !self.programs.is_empty();
        let is_programs = |file: &HandedFile| {
            let inner = in_program(&self.programs, file);
            inner.is_some_and(|path| path.starts_with("src/"))
        };
        let mut others = Vec::new();
        for file in &self.files {
            match &file.content {
                _ if is_exercise(file) => {}
                Content::Problem(problem) => {
                    others.push(format!("{} ({problem})", file.path_text()));
                }
                _ if has_others && !may_be_rust(file.name()) => {}
                _ if is_programs(file) => {}
                _ => others.push(file.path_text()),
            }
        }
        if others.is_empty() && has_others {
            return Found::Nothing;
        }
        let is_empty = others.is_empty();
        let names = names(others.into_iter());
        Found::Unclear(match (has_others, is_empty) {
            (true, _) => format!("not found, unless it is in {names}"),
            (false, true) => "it is empty".to_owned(),
            (false, false) => format!("no file has the name of an exercise; it has {names}"),
        })
    }
}

/// The path of a file in the program around it.
fn in_program(programs: &[&[String]], file: &HandedFile) -> Option<String> {
    let inner = |folder: &&[String]| file.path.strip_prefix(*folder);
    programs.iter().find_map(inner).map(|path| path.join("/"))
}

/// Whether a file has the name of an exercise.
fn is_of(file: &HandedFile, e: &Exercise) -> bool {
    let stem = file.name().to_lowercase();
    stem.strip_suffix(".rs") == Some(e.name)
}

/// Names in a message, and how many others there are.
pub fn names(all: impl ExactSizeIterator<Item = String>) -> String {
    let count = all.len();
    let first = all.take(MAX_NAMES).collect::<Vec<_>>().join(", ");
    match count.checked_sub(MAX_NAMES) {
        None | Some(0) => first,
        Some(more) => format!("{first} and {more} more"),
    }
}
