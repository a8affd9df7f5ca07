//! `Progress`: which exercises are done.
//!
//! What is kept of an exercise is the hash of the student's file that a check has found right. So
//! it is done as long as its file is that one: it is open again after an edit, a reset, or when
//! the file is deleted. A line of the file `.learn` is the name of an exercise and the hash; another
//! line counts for nothing.

use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;

use common::{atomic_file, fnv1a};
use judge::pictures::Sheet;

use crate::exercise::Exercise;
use crate::files;
use crate::sheet;
use crate::student_file;

const FILE: &str = ".learn";

/// Hashes of right files, by the names of the exercises.
type Hashes = BTreeMap<String, u64>;

/// The exercises that are done.
#[derive(Default)]
pub struct Progress {
    hashes: Hashes,
}

/// What is kept now; nothing if there is no file.
fn read_hashes() -> Result<Hashes, String> {
    let path = files::shortest(FILE);
    let bytes = match fs::read(&path) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Hashes::new()),
        Err(error) => return Err(files::with_path(&path)(error)),
    };
    let mut hashes = Hashes::new();
    for line in String::from_utf8_lossy(&bytes).lines() {
        if let Some((name, hash)) = line.split_once(' ')
            && let Ok(hash) = u64::from_str_radix(hash, 16)
        {
            hashes.insert(name.to_owned(), hash);
        }
    }
    Ok(hashes)
}

/// Writes the file, which is complete whenever the program ends.
fn write_hashes(hashes: &Hashes) -> Result<(), String> {
    let lines: Vec<_> = hashes
        .iter()
        .map(|(name, hash)| format!("{name} {hash:016x}\n"))
        .collect();
    let written = atomic_file::write(&files::shortest(FILE), lines.concat().as_bytes());
    written.map_err(|error| error.to_string())
}

impl Progress {
    /// What is kept now; nothing if it cannot be read.
    pub fn read() -> Self {
        Self {
            hashes: read_hashes().unwrap_or_default(),
        }
    }

    /// Whether the student's file is the one that a check has found right.
    pub fn is_done(&self, exercise: &Exercise) -> bool {
        let Some(hash) = self.hashes.get(exercise.name) else {
            return false;
        };
        fs::read(student_file::path(exercise)).is_ok_and(|text| fnv1a(&text) == *hash)
    }

    /// Records what a check says about a text. An error says why it is not kept: then this program
    /// knows it until its end.
    pub fn record(&mut self, exercise: &Exercise, text: &str, is_done: bool) -> Result<(), String> {
        // Another `cargo learn` may have recorded something since.
        let kept = read_hashes();
        if let Ok(kept) = &kept {
            self.hashes.clone_from(kept);
        }
        if is_done {
            let hash = fnv1a(text.as_bytes());
            self.hashes.insert(exercise.name.to_owned(), hash);
        } else {
            self.hashes.remove(exercise.name);
        }
        // What cannot be read is not replaced.
        kept?;
        write_hashes(&self.hashes)
    }

    /// How far the student is with an exercise, in a word.
    pub fn mark(&self, exercise: &Exercise) -> &'static str {
        if self.is_done(exercise) {
            "done"
        } else if student_file::is_begun(exercise) {
            "begun"
        } else {
            ""
        }
    }

    /// The next open exercise: a later one on the same path as the `last`, or the first of the
    /// core path, or the first of the others. None if all are done.
    pub fn next<'a>(
        &self,
        course: &'a [Exercise],
        last: Option<&Exercise>,
    ) -> Option<&'a Exercise> {
        let is_core = last.is_some_and(|last| last.is_core);
        let place = course.iter().position(|e| Some(e) == last);
        let later = place.map_or(&[][..], |place| &course[place + 1..]);
        let on_path = later.iter().filter(|e| e.is_core == is_core);
        let core = course.iter().filter(|e| e.is_core);
        let mut candidates = on_path.chain(core).chain(course);
        candidates.find(|e| !self.is_done(e))
    }

    /// How many exercises of the core path and of the others are done.
    pub fn summary(&self, course: &[Exercise]) -> String {
        let mut words = Vec::new();
        for (path, is_core) in [("core path", true), ("further", false)] {
            let of_path = course.iter().filter(|e| e.is_core == is_core);
            let all = of_path.clone().count();
            let done = of_path.filter(|e| self.is_done(e)).count();
            words.push(format!("{path}: {done} of {all} done"));
        }
        words.join(", ")
    }

    /// The sheets of which the core path of the stage is done.
    pub fn open_sheets(&self, course: &[Exercise]) -> Result<Vec<Sheet>, String> {
        let mut sheets = sheet::read_all()?;
        sheets.retain(|sheet| {
            let mut core = course
                .iter()
                .filter(|e| e.is_core && e.stage == sheet.stage);
            core.all(|e| self.is_done(e))
        });
        Ok(sheets)
    }

    /// The sheets that an exercise has opened, being the last of its stage's core path, in words.
    pub fn opened_by(&self, course: &[Exercise], e: &Exercise) -> Option<String> {
        let mut sheets = self.open_sheets(course).ok()?;
        sheets.retain(|sheet| e.is_core && sheet.stage == e.stage);
        (!sheets.is_empty()).then(|| sheet::open_words(&sheets))
    }

    /// An exercise in a line.
    pub fn row(&self, e: &Exercise) -> String {
        let (mark, stage) = (self.mark(e), &e.stage[..3]);
        let path = if e.is_core { "core" } else { "" };
        let (name, title, minutes) = (e.name, e.title, e.minutes);
        format!("{mark:5}  {path:4}  {stage}  {name:17} {minutes:>2} min  {title}")
    }

    /// All exercises, one a line.
    pub fn list(&self, course: &[Exercise]) -> String {
        let mut lines: Vec<_> = course.iter().map(|e| self.row(e)).collect();
        lines.push(String::new());
        lines.push(self.summary(course));
        match self.open_sheets(course) {
            Ok(sheets) if sheets.is_empty() => {}
            Ok(sheets) => lines.push(sheet::open_words(&sheets)),
            Err(problem) => lines.push(problem),
        }
        lines.join("\n")
    }
}
