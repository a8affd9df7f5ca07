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

use crate::exercise::Exercise;
use crate::files;

const FILE: &str = ".learn";

/// The longest bar in characters, and what else stands in its line.
const BAR: usize = 30;
const BESIDE_BAR: usize = 22;

/// Hashes of right files, by the names of the exercises.
type Hashes = BTreeMap<String, u64>;

/// The exercises that are done.
#[derive(Default)]
pub struct Progress {
    hashes: Hashes,
    /// Why nothing is kept. The program then knows until its end what is done.
    problem: Option<String>,
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
    /// What is kept now.
    pub fn read() -> Self {
        match read_hashes() {
            Ok(hashes) => Self {
                hashes,
                problem: None,
            },
            Err(problem) => Self {
                hashes: Hashes::new(),
                problem: Some(problem),
            },
        }
    }

    /// Whether the student's file is the one that a check has found right.
    pub fn is_done(&self, exercise: &Exercise) -> bool {
        let Some(hash) = self.hashes.get(exercise.name) else {
            return false;
        };
        fs::read(files::yours(exercise)).is_ok_and(|text| fnv1a(&text) == *hash)
    }

    /// Records what a check says about a text.
    pub fn record(&mut self, exercise: &Exercise, text: &str, is_done: bool) {
        let set = |hashes: &mut Hashes| {
            let name = exercise.name.to_owned();
            if is_done {
                hashes.insert(name, fnv1a(text.as_bytes()));
            } else {
                hashes.remove(&name);
            }
        };
        set(&mut self.hashes);
        // Another `cargo learn` may have recorded something since. What cannot be read is not
        // replaced.
        let written = read_hashes().and_then(|mut now| {
            if self.problem.is_some() {
                now.extend(self.hashes.clone());
            }
            set(&mut now);
            write_hashes(&now)?;
            Ok(now)
        });
        match written {
            Ok(now) => {
                self.hashes = now;
                self.problem = None;
            }
            Err(problem) => self.problem = Some(problem),
        }
    }

    /// Says that the next program will not know what is done, if so.
    pub fn warning(&self) -> Option<String> {
        let problem = self.problem.as_ref()?;
        Some(format!("what is done is not kept: {problem}"))
    }

    /// How far the student is with an exercise, in a word.
    pub fn mark(&self, exercise: &Exercise) -> &'static str {
        if self.is_done(exercise) {
            "done"
        } else if files::is_begun(exercise) {
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

    /// A bar for the core path and one for the further exercises, in lines of this width.
    pub fn bars(&self, course: &[Exercise], width: Option<usize>) -> String {
        let most = width.map_or(BAR, |width| width.saturating_sub(BESIDE_BAR).min(BAR));
        let core = self.bar("core path", course, true, most);
        let further = self.bar("further  ", course, false, most);
        format!("{core}\n{further}")
    }

    fn bar(&self, words: &str, course: &[Exercise], is_core: bool, length: usize) -> String {
        let path = course.iter().filter(|e| e.is_core == is_core);
        let all = path.clone().count();
        let done = path.filter(|e| self.is_done(e)).count();
        let full = "#".repeat(length * done / all.max(1));
        format!("{words} [{full:.<length$}] {done} of {all}")
    }

    /// All exercises, one a line.
    pub fn list(&self, course: &[Exercise]) -> String {
        let mut lines = Vec::new();
        for of_stage in course.chunk_by(|a, b| a.stage == b.stage) {
            lines.push(of_stage[0].stage.to_owned());
            for e in of_stage {
                let mark = self.mark(e);
                let path = if e.is_core { "core" } else { "" };
                let (name, title, minutes) = (e.name, e.title, e.minutes);
                let row = format!("  {mark:5}  {path:4}  {name:18} {title}, {minutes} minutes");
                lines.push(row);
            }
        }
        format!("{}\n\n{}", lines.join("\n"), self.bars(course, None))
    }
}
