//! `Collected`: who has handed in. Each folder and each archive directly in what was collected is a student of
//! its name, also one that cannot be opened, and so is a loose Rust file. Nothing else is.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use common::text;
use learn::exercise::Exercise;
use learn::files::with_path;

use crate::hand_in::files_in;
use crate::handed_file::{HandedFile, is_added, is_archive, may_be_rust};

/// A folder, archive or file, whose name is the student's.
#[derive(Debug)]
pub struct Student {
    pub name: String,
    /// The name of its files in the folder of the results, which no other student has.
    pub file_name: String,
    place: PathBuf,
}

/// The students, and the names of all that is nobody's.
#[derive(Debug, Default)]
pub struct Collected {
    pub students: Vec<Student>,
    pub of_nobody: Vec<String>,
}

impl Collected {
    /// The students in these folders; a file is a student as if it stood in one.
    pub fn read(places: &[PathBuf], course: &[Exercise]) -> Result<Self, String> {
        let mut entries = Vec::new();
        for place in places {
            if !place.exists() {
                return Err(format!("there is no {}", text::path(place)));
            }
            if !place.is_dir() {
                entries.push(place.clone());
                continue;
            }
            for entry in fs::read_dir(place).map_err(with_path(place))? {
                entries.push(entry.map_err(with_path(place))?.path());
            }
        }
        entries.sort();
        entries.dedup();
        let mut collected = Self::default();
        let (mut taken, mut file_names) = (BTreeSet::new(), BTreeSet::new());
        for place in entries {
            let whole = place.file_name().unwrap_or(place.as_os_str());
            let whole = whole.to_string_lossy().into_owned();
            if is_added(&whole) || !is_student(&place, &whole) {
                collected.of_nobody.push(text::visible(&whole));
                continue;
            }
            if whole == "exercises" || course.iter().any(|e| e.stage == whole) {
                return Err(format!(
                    "{} is a folder of the workbook, and no student; give the folder around those of the students",
                    text::path(&place)
                ));
            }
            let mut name = text::visible(without_extensions(&whole));
            // Of two such as `ada` and `ada.zip` nobody knows which one counts: each is a row.
            if !taken.insert(name.clone()) {
                name = text::path(&place);
            }
            let mut file_name = file_name(&name);
            // Windows takes capital letters for small ones.
            while !file_names.insert(file_name.to_lowercase()) {
                file_name.push('_');
            }
            collected.students.push(Student {
                name,
                file_name,
                place,
            });
        }
        if collected.students.is_empty() && !places.is_empty() {
            return Err("there is no folder and no zip file of a student".to_owned());
        }
        Ok(collected)
    }
}

impl Student {
    /// All files of the student.
    pub fn files(&self) -> Vec<HandedFile> {
        files_in(&self.place)
    }
}

/// Whether a place is a student's: a link is one, too, which is not followed.
fn is_student(place: &Path, name: &str) -> bool {
    let is_file = fs::symlink_metadata(place).is_ok_and(|place| place.is_file());
    !is_file || is_archive(name) || may_be_rust(name)
}

/// A name without `.zip`, `.tar.gz`, `.rs` and the like.
fn without_extensions(name: &str) -> &str {
    let mut short = name;
    while let Some((before, _)) = short.rsplit_once('.')
        && !before.is_empty()
        && (is_archive(short) || may_be_rust(short))
    {
        short = before;
    }
    short
}

/// A name for a file, which is in no other folder.
fn file_name(name: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || " -_().,".contains(c);
    let name: String = name
        .chars()
        .map(|c| if is_plain(c) { c } else { '_' })
        .collect();
    name.trim_start_matches('.').to_owned()
}
