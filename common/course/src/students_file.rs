//! `StudentsFile`: a file in a hand-in, and what it is by its path: the file of an exercise, a part of the
//! workbook, a text of the platform, or something that a person has to look at.

use common::text;
use learn::exercise::Exercise;

use crate::file_name::{is_late, person, split_time, stem};
use crate::hand_in::{Content, HandedFile};

/// Folders of the workbook beside or around the students' files, whose files have the same names.
const OF_WORKBOOK: [&str; 9] = [
    "answers",
    "benches",
    "examples",
    "functions",
    "kinds",
    "others",
    "solutions",
    "src",
    "tests",
];

/// The folder of a student's files in a stage.
const EXERCISES: &str = "exercises";

/// Extensions of files that may hold an exercise under another name.
const MAY_HOLD_CODE: [&str; 9] = ["rs", "zip", "7z", "rar", "tar", "gz", "tgz", "xz", "bz2"];

/// Extensions of tables and texts, which a platform adds and no student hands in as code.
const TEXTS: [&str; 12] = [
    "", "csv", "htm", "html", "json", "md", "ods", "txt", "xls", "xlsx", "yaml", "yml",
];

/// A file in the submission of a student.
#[derive(Debug)]
pub struct StudentsFile {
    /// The folders around it that are no part of the workbook.
    pub folders: Vec<String>,
    /// Its path below the place that was handed in.
    pub path: String,
    pub content: Content,
    pub kind: Kind,
    /// The words before the name of the exercise.
    pub person: String,
    pub is_late: bool,
    /// When it was handed in, if a name says so.
    pub time: String,
}

/// The kind of a handed-in file, which its path tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Exercise(&'static str),
    /// It may be one, under another name.
    Unknown,
    /// A text or table, or a folder.
    Text,
    /// A part of the workbook, or something else that is no exercise.
    Other,
}

impl StudentsFile {
    /// A file in a place whose path has `typed` parts.
    pub fn new(file: HandedFile, typed: usize, course: &'static [Exercise]) -> Self {
        let (name, around) = match file.path.split_last() {
            Some((name, around)) => (name.as_str(), around),
            None => ("", &[][..]),
        };
        let typed = typed.min(around.len());
        let is_stage = |folder: &str| course.iter().any(|e| e.stage == folder);
        let is_own = |folder: &String| folder == EXERCISES || is_stage(folder);
        let first = around[typed..].iter().position(is_own);
        let (before, workbook) = around.split_at(first.map_or(around.len(), |at| typed + at));

        let (stem, extension) = stem(name);
        let mut named = None;
        for e in course {
            // The longest name counts.
            if let Some(person) = person(&stem, e.name)
                && named.is_none_or(|(other, _): (&str, &str)| e.name.len() > other.len())
            {
                named = Some((e.name, person));
            }
        }
        let is_listed = |folder: &String| OF_WORKBOOK.contains(&&**folder);
        let kind = match named {
            _ if is_of_workbook(workbook) => Kind::Other,
            Some((name, _)) if extension == "rs" && !before.last().is_some_and(is_listed) => {
                Kind::Exercise(name)
            }
            Some(_) => Kind::Unknown,
            None if TEXTS.contains(&&*extension) => Kind::Text,
            None if before[typed..].iter().any(is_listed) || !workbook.is_empty() => Kind::Other,
            None if MAY_HOLD_CODE.contains(&&*extension) => Kind::Unknown,
            None => Kind::Other,
        };
        let mut time = String::new();
        let mut is_late_in = false;
        for part in &file.path[typed.saturating_sub(1)..] {
            time = split_time(part).1.unwrap_or(time);
            is_late_in |= is_late(part);
        }
        let inner = before[typed..].iter().filter(|folder| *folder != "late");
        Self {
            folders: before[..typed].iter().chain(inner).cloned().collect(),
            path: text::visible(&file.path[typed..].join("/")),
            content: file.content,
            kind,
            person: named.map_or("", |(_, person)| person).to_owned(),
            is_late: is_late_in,
            time,
        }
    }
}

/// Whether folders that begin with a stage or with its exercises hold something else than a student's
/// file: the lesson, a check, a starter.
fn is_of_workbook(folders: &[String]) -> bool {
    let inner = match folders {
        [] | [_] => return false,
        [first, inner @ ..] if first == EXERCISES => inner,
        [_, second, inner @ ..] if second == EXERCISES => inner,
        _ => return true,
    };
    inner.iter().any(|folder| OF_WORKBOOK.contains(&&**folder))
}
