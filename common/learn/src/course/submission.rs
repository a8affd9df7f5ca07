//! `Submission`: the files of a student, in a folder, a zip file, or the export of a learning platform,
//! and which of them is the file of an exercise.

use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Component, Path, PathBuf};

use super::hand_in::{Content, HandedFile, files_in, has_extension};
use super::platform::{named, own_name};
use crate::exercise::Exercise;
use crate::files;

/// The most names in a message.
const MOST_NAMES: usize = 10;

/// The word for several files of an exercise.
pub const COPIES: &str = "copies";

/// Extensions of files that may hold an exercise under a name that does not say so.
const MAY_HOLD_CODE: [&str; 12] = [
    "rs", "txt", "html", "htm", "zip", "7z", "rar", "tar", "gz", "tgz", "xz", "bz2",
];

/// Texts that no student has written: of `cargo learn submit`, and about a hand-in on a platform.
const NOTES: [&str; 2] = ["results.txt", "receipt"];

/// Folders beside the students' files, whose files have the same names.
const BESIDE: [&str; 4] = ["starters", "solutions", "hints", files::OPEN];

/// What a folder or zip file holds.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Holds {
    /// The files of one student.
    OneStudent,
    /// A folder or a zip file for each student.
    Class,
    /// The files of the students whom a learning platform names; if it names none, those of one.
    Export,
}

/// The files of a student.
#[derive(Debug)]
pub struct Submission {
    /// Folders, zip files and the name of the student, as many of them as tell students apart.
    pub name: String,
    files: Vec<StudentsFile>,
}

#[derive(Debug)]
struct StudentsFile {
    /// Its name, after the folders and zip files that are the student's.
    path: String,
    content: Content,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// The file of an exercise, named so in the same letters, or in others of upper and lower case.
    Exercise { name: &'static str, is_exact: bool },
    /// It may be one, under another name.
    Unknown,
    /// A part of the workbook, or a file that cannot be an exercise.
    Other,
}

/// The file of an exercise in a submission.
#[derive(Debug, PartialEq, Eq)]
pub enum Found<'a> {
    File {
        path: &'a str,
        text: &'a str,
    },
    Nothing,
    /// Nobody can tell without a look; why, in words for the student.
    Unclear(String),
}

/// The submissions in folders and zip files, in the order of their names.
pub fn read(
    places: &[PathBuf],
    holds: Holds,
    course: &'static [Exercise],
) -> io::Result<Vec<Submission>> {
    let is_wanted = |name: &str| {
        let name = name.to_lowercase();
        has_extension(&name, "rs") && course.iter().any(|e| name.contains(e.name))
    };
    let mut typed_before = BTreeSet::new();
    let mut submissions: BTreeMap<Vec<String>, Vec<StudentsFile>> = BTreeMap::new();
    for place in places {
        let typed = typed(place)?;
        if !typed_before.insert(typed.clone()) {
            continue;
        }
        let found = files_in(place, &typed, &is_wanted);
        if found.is_empty() {
            submissions.entry(typed.clone()).or_default();
        }
        let folders_of_all = shared_parts(&found);
        let mut of_nobody = Vec::new();
        let mut has_students = false;
        for file in found {
            let (student, own) = match holds {
                Holds::OneStudent => split(&file.path, typed.len()),
                Holds::Class => split(&file.path, folders_of_all.max(typed.len()) + 1),
                Holds::Export => by_platform(&file.path, typed.len()),
            };
            let file = StudentsFile {
                kind: kind(&own, course),
                path: own.join("/"),
                content: file.content,
            };
            if student == typed {
                of_nobody.push(file);
            } else {
                has_students = true;
                submissions.entry(student).or_default().push(file);
            }
        }
        // A platform may add tables about the class.
        if has_students {
            of_nobody.retain(|file| file.kind != Kind::Other);
        }
        if !of_nobody.is_empty() {
            submissions.entry(typed).or_default().extend(of_nobody);
        }
    }
    Ok(with_names(submissions))
}

/// The submissions, named by the parts of their paths that are not those of all.
fn with_names(submissions: BTreeMap<Vec<String>, Vec<StudentsFile>>) -> Vec<Submission> {
    let paths: Vec<_> = submissions.keys().collect();
    let mut shared = 0;
    while paths.iter().all(|path| shared + 1 < path.len())
        && paths.iter().all(|path| path[shared] == paths[0][shared])
    {
        shared += 1;
    }
    let mut named = Vec::new();
    for (path, files) in submissions {
        let name = path[shared..].join("/");
        named.push(Submission { name, files });
    }
    named
}

/// The parts of a path as it is typed; of a path such as `..`, those of the folder.
fn typed(place: &Path) -> io::Result<Vec<String>> {
    let mut path = place.to_owned();
    if place.file_name().is_none() {
        path = place.canonicalize()?;
    }
    let mut parts = Vec::new();
    for part in path.components() {
        if let Component::Normal(part) = part {
            parts.push(part.to_string_lossy().into_owned());
        }
    }
    Ok(parts)
}

/// How many folders and zip files are around all files.
fn shared_parts(found: &[HandedFile]) -> usize {
    let Some(first) = found.first() else {
        return 0;
    };
    let mut shared = first.path.len() - 1;
    for file in found {
        let pairs = file.path[..file.path.len() - 1].iter().zip(&first.path);
        shared = shared.min(pairs.take_while(|(a, b)| a == b).count());
    }
    shared
}

/// The first parts of a path, and the others; a file alone stands in both.
fn split(path: &[String], count: usize) -> (Vec<String>, Vec<String>) {
    let count = count.min(path.len());
    let own = if count == path.len() {
        &path[count.saturating_sub(1)..]
    } else {
        &path[count..]
    };
    (path[..count].to_vec(), own.to_vec())
}

/// The path of the student whom a platform names first in a path, and the parts that are the
/// student's. So many parts are typed, of which the last two may be named by it.
fn by_platform(path: &[String], typed: usize) -> (Vec<String>, Vec<String>) {
    for index in typed.saturating_sub(2)..path.len() {
        let folder = index.checked_sub(1).map(|index| path[index].as_str());
        let is_file = index + 1 == path.len() || has_extension(&path[index], "zip");
        let Some(found) = named(folder, &path[index], is_file) else {
            continue;
        };
        let mut student = path[..index].to_vec();
        student.push(found.student);
        let mut own: Vec<_> = found.file.into_iter().collect();
        own.extend_from_slice(&path[index + 1..]);
        if own.is_empty() {
            own.push(path[index].clone());
        }
        return (student, own);
    }
    split(path, typed)
}

/// What a file is, by its path.
fn kind(path: &[String], course: &'static [Exercise]) -> Kind {
    let (name, folders) = path
        .split_last()
        .map_or(("", path), |(name, folders)| (name.as_str(), folders));
    if NOTES.contains(&name) || is_of_workbook(path, folders, course) {
        return Kind::Other;
    }
    let own = own_name(name);
    if let Some(stem) = without_extension(&own) {
        for e in course {
            if e.name.eq_ignore_ascii_case(stem) {
                return Kind::Exercise {
                    name: e.name,
                    is_exact: e.name == stem,
                };
            }
        }
    }
    if MAY_HOLD_CODE
        .iter()
        .any(|extension| has_extension(name, extension))
    {
        Kind::Unknown
    } else {
        Kind::Other
    }
}

/// A name without `.rs`.
fn without_extension(name: &str) -> Option<&str> {
    let (stem, extension) = name.rsplit_once('.')?;
    extension.eq_ignore_ascii_case("rs").then_some(stem)
}

/// Whether a path is that of a file of the workbook, which a student may hand in as a whole: such as
/// a lesson, `src/sphere.rs`, but not `exercises/sphere.rs`.
fn is_of_workbook(path: &[String], folders: &[String], course: &'static [Exercise]) -> bool {
    let folders: Vec<_> = folders.iter().map(String::as_str).collect();
    match folders.as_slice() {
        [.., "tests", "exercises"] => return true,
        [.., "exercises"] | [] => return false,
        [.., last] if BESIDE.contains(last) => return true,
        _ => {}
    }
    let is_stage = |folder: &str| course.iter().any(|e| e.stage == folder);
    if let Some(stage) = folders.iter().rposition(|folder| is_stage(folder))
        && folders
            .get(stage + 1)
            .is_some_and(|next| *next != "exercises")
    {
        return true;
    }
    let workbook = files::workspace();
    (0..folders.len()).any(|first| {
        let end: PathBuf = path[first..].iter().collect();
        let stages = course.chunk_by(|a, b| a.stage == b.stage);
        workbook.join(&end).is_file()
            || stages
                .map(|stage| workbook.join(stage[0].stage))
                .any(|stage| stage.join(&end).is_file())
    })
}

impl Submission {
    /// The file of an exercise.
    pub fn find(&self, e: &Exercise) -> Found<'_> {
        let mut copies = Vec::new();
        for wants_exact in [true, false] {
            if copies.is_empty() {
                let wanted = Kind::Exercise {
                    name: e.name,
                    is_exact: wants_exact,
                };
                copies.extend(self.files.iter().filter(|file| file.kind == wanted));
            }
        }
        match copies.as_slice() {
            [] => self.without_file(),
            [file] => match &file.content {
                Content::Text(text) => Found::File {
                    path: &file.path,
                    text,
                },
                Content::Problem(problem) => Found::Unclear(format!("{} {problem}", file.path)),
                Content::NotWanted => Found::Unclear(format!("{} is not read", file.path)),
            },
            copies => {
                let names = names(copies.iter().map(|file| file.path.clone()));
                let count = copies.len();
                Found::Unclear(format!("there are {count} {COPIES}: {names}; hand in one"))
            }
        }
    }

    /// Whether an exercise without a file is not handed in, or there are files that may be it.
    fn without_file(&self) -> Found<'_> {
        let is_exercise = |file: &StudentsFile| matches!(file.kind, Kind::Exercise { .. });
        let has_exercises = self.files.iter().any(is_exercise);
        let mut others = Vec::new();
        for file in &self.files {
            let is_listed = match file.kind {
                Kind::Exercise { .. } => false,
                Kind::Unknown => true,
                Kind::Other => !has_exercises,
            };
            if is_listed {
                others.push(match &file.content {
                    Content::Problem(problem) => format!("{}, which {problem}", file.path),
                    _ => file.path.clone(),
                });
            }
        }
        if has_exercises && others.is_empty() {
            return Found::Nothing;
        }
        let count = others.len();
        let names = names(others.into_iter());
        Found::Unclear(match (has_exercises, count) {
            (true, _) => format!("not found, unless it is in {names}"),
            (false, 0) => "it is empty".to_owned(),
            (false, _) => format!("no file has the name of an exercise; it has {names}"),
        })
    }
}

/// Names in a message, and how many others there are.
fn names(all: impl ExactSizeIterator<Item = String>) -> String {
    let count = all.len();
    let first = all.take(MOST_NAMES).collect::<Vec<_>>().join(", ");
    match count.checked_sub(MOST_NAMES) {
        None | Some(0) => first,
        Some(more) => format!("{first} and {more} more"),
    }
}

#[cfg(test)]
mod tests;
