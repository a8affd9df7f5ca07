//! `Submission`: the files of a student, and which of them is the file of an exercise.
//!
//! The student is the name of a folder, of a zip file, or of a file without the exercise in it. The
//! exercise is the name of the file.

#[cfg(test)]
mod tests;

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{io, mem};

use common::text;
use learn::exercise::Exercise;

use crate::file_name::split_time;
use crate::hand_in::{Content, files_in, is_zip};
use crate::students_file::{Kind, StudentsFile};

/// The most names in a message.
const MOST_NAMES: usize = 10;

/// The files of a student.
#[derive(Debug)]
pub struct Submission {
    /// The student.
    pub name: String,
    files: Vec<StudentsFile>,
}

/// The file of an exercise in a submission.
#[derive(Debug, PartialEq, Eq)]
pub enum Found<'a> {
    File {
        path: &'a str,
        text: &'a str,
        /// That it is late, or the later one of several.
        note: String,
    },
    Nothing,
    /// Nobody can tell without a look; why, in words for the student.
    Unclear(String),
}

/// The submissions in folders and zip files, in the order of their names.
pub fn read(places: &[PathBuf], course: &'static [Exercise]) -> io::Result<Vec<Submission>> {
    let is_wanted = |name: &str| course.iter().any(|e| name.to_lowercase().contains(e.name));
    let mut students: BTreeMap<String, Vec<StudentsFile>> = BTreeMap::new();
    for place in places {
        let root = root(place)?;
        let mut files = Vec::new();
        for file in files_in(place, &root, &is_wanted) {
            files.push(StudentsFile::new(file, root.len(), course));
        }
        let (level, is_class) = level(&files, root[..1].to_vec());
        for mut file in files {
            let mut student = match file.folders.get(level.len()) {
                _ if !is_class => level.join("/"),
                Some(folder) => split_time(folder).0,
                // A table beside the students' folders is nobody's.
                None if file.kind == Kind::Text => continue,
                None => mem::take(&mut file.person),
            };
            if !file.person.is_empty() {
                // Of a known student, it is named neither after a student nor after an exercise.
                file.kind = Kind::Unknown;
            }
            if is_class && places.len() > 1 {
                student = [&level[0], "/", &student].concat();
            }
            let name = text::visible(&student.replace(".zip", ""));
            students.entry(name).or_default().push(file);
        }
    }
    let named = students.into_iter();
    let named = named.map(|(name, files)| Submission { name, files });
    Ok(named.collect())
}

/// The name of a folder or zip file; of another file, those of its folder and of the file.
pub fn root(place: &Path) -> io::Result<Vec<String>> {
    let place = place.canonicalize()?;
    let mut names = Vec::new();
    for part in &place {
        names.push(part.to_string_lossy().into_owned());
    }
    let is_alone = place.is_file() && !names.last().is_some_and(|name| is_zip(name));
    let first = names.len().saturating_sub(1 + usize::from(is_alone));
    Ok(names.split_off(first))
}

/// The folders around all students, and whether there is a class in them: a folder or a file for
/// each student. Otherwise the last folder is the student's. A folder that is alone is entered.
fn level(files: &[StudentsFile], mut level: Vec<String>) -> (Vec<String>, bool) {
    loop {
        let mut folders = BTreeSet::new();
        let mut here = Vec::new();
        for file in files.iter().filter(|file| file.folders.starts_with(&level)) {
            match file.folders.get(level.len()) {
                Some(folder) => drop(folders.insert(folder)),
                None if file.kind == Kind::Text => {}
                None => here.push(file),
            }
        }
        if !here.is_empty() {
            here.retain(|file| matches!(file.kind, Kind::Exercise(_)));
            let are_named = !here.is_empty() && here.iter().all(|file| !file.person.is_empty());
            let is_class = are_named || has_copies(files, level.len());
            return (level, is_class);
        }
        match folders.pop_first() {
            Some(only) if folders.is_empty() => level.push(only.clone()),
            other => return (level, other.is_some()),
        }
    }
}

/// Whether an exercise is in two folders of a level.
fn has_copies(files: &[StudentsFile], level: usize) -> bool {
    let mut first = BTreeMap::new();
    for file in files {
        if let (Kind::Exercise(name), Some(folder)) = (file.kind, file.folders.get(level))
            && *first.entry(name).or_insert(folder) != folder
        {
            return true;
        }
    }
    false
}

impl Submission {
    /// The file of an exercise: of several that differ, the latest, if their names have times.
    pub fn find(&self, e: &Exercise) -> Found<'_> {
        let mut copies: Vec<&StudentsFile> = Vec::new();
        for file in &self.files {
            let is_same =
                |copy: &&StudentsFile| copy.content == file.content && copy.is_late == file.is_late;
            if file.kind == Kind::Exercise(e.name) && !copies.iter().any(is_same) {
                copies.push(file);
            }
        }
        copies.sort_by_key(|file| Reverse((file.is_late, &file.time)));
        let latest = match copies.as_slice() {
            [] => return self.without_file(),
            [first, second, ..]
                if (first.is_late, &first.time) == (second.is_late, &second.time) =>
            {
                let count = copies.len();
                let names = names(copies.iter().map(|file| file.path.clone()));
                return Found::Unclear(format!("there are {count} copies: {names}; hand in one"));
            }
            [first, ..] => first,
        };
        let text = match &latest.content {
            Content::Text(text) => text,
            Content::Problem(problem) => {
                return Found::Unclear(format!("{}: {problem}", latest.path));
            }
            Content::NotWanted => {
                return Found::Unclear(format!("{}: it is not read", latest.path));
            }
        };
        let mut notes = Vec::new();
        if latest.is_late {
            notes.push("late".to_owned());
        }
        if copies.len() > 1 {
            notes.push(format!("the latest of {}", copies.len()));
        }
        Found::File {
            path: &latest.path,
            text,
            note: notes.join(", "),
        }
    }

    /// Whether an exercise without a file is not handed in, or there are files that may be it.
    fn without_file(&self) -> Found<'_> {
        let is_exercise = |file: &StudentsFile| matches!(file.kind, Kind::Exercise(_));
        let has_exercises = self.files.iter().any(is_exercise);
        let mut others = Vec::new();
        for file in &self.files {
            let is_folder = file.path.is_empty() || file.path.ends_with('/');
            let is_listed = match file.kind {
                Kind::Exercise(_) => false,
                Kind::Unknown => true,
                Kind::Text | Kind::Other => !has_exercises && !is_folder,
            };
            if is_listed {
                others.push(match &file.content {
                    Content::Problem(problem) => format!("{} ({problem})", file.path),
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
