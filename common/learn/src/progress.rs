//! `Progress`: which exercises are done.
//!
//! What is kept of an exercise is the hash of the student's file that a check has found right. So
//! it is done as long as its file is that one: it is open again after an edit, a reset, or when
//! the file is deleted.

use std::fs;

use common::fnv1a;

use crate::exercise::Exercise;
use crate::files;
use crate::kept::Kept;

/// The longest bar in characters, and what else stands in its line.
const BAR: usize = 30;
const BESIDE_BAR: usize = 22;

/// The exercises that are done.
#[derive(Default)]
pub struct Progress {
    kept: Kept,
    /// Why nothing is kept. The program then knows until its end what is done.
    problem: Option<String>,
}

impl Progress {
    /// What is kept now.
    pub fn read() -> Self {
        match Kept::read() {
            Ok(kept) => Self {
                kept,
                problem: None,
            },
            Err(problem) => Self {
                kept: Kept::default(),
                problem: Some(problem),
            },
        }
    }

    /// Whether the student's file is the one that a check has found right.
    pub fn is_done(&self, exercise: &Exercise) -> bool {
        let Some(hash) = self.kept.hashes.get(exercise.name) else {
            return false;
        };
        fs::read(files::yours(exercise)).is_ok_and(|text| fnv1a(&text) == *hash)
    }

    /// Records what a check says about a text.
    pub fn record(&mut self, exercise: &Exercise, text: &str, is_done: bool) {
        let set = |kept: &mut Kept| {
            let name = exercise.name.to_owned();
            if is_done {
                kept.hashes.insert(name, fnv1a(text.as_bytes()));
            } else {
                kept.hashes.remove(&name);
            }
        };
        set(&mut self.kept);
        // Another `cargo learn` may have recorded something since. What cannot be read is not
        // replaced.
        let written = Kept::read().and_then(|mut now| {
            if self.problem.is_some() {
                now.hashes.extend(self.kept.hashes.clone());
            }
            set(&mut now);
            now.write()?;
            Ok(now)
        });
        match written {
            Ok(now) => {
                self.kept = now;
                self.problem = None;
            }
            Err(problem) => self.problem = Some(problem),
        }
    }

    /// Says that the next program will not know what is done, or that a part of what was kept
    /// cannot be read, if so.
    pub fn warning(&self) -> Option<String> {
        match &self.problem {
            Some(problem) => Some(format!("what is done is not kept: {problem}")),
            None => self.kept.warning(),
        }
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
