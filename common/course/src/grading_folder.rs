//! `GradingFolder`: the folder `target/grading`, in which one file after the other is compiled and
//! judged. It remains, so that the next grading has nothing to build.
//!
//! Gradings at the same time share it: each locks it while it judges a file.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use learn::exercise::Exercise;
use learn::files::{self, with_path};
use learn::starter;

use crate::exercise_record::{record, record_file};
use crate::handout::{Handout, Workbook, paths_in};
use crate::program_output::output_of;
use crate::sandbox::{End, Ended, Limits, Place, Sandbox};
use crate::submission::StudentFile;

/// The folder of all gradings.
pub struct GradingFolder {
    pub sandbox: Sandbox,
    /// Why the starters of exercises do not build, by name: none of one that does. A fault of the workbook is
    /// no fault of a student.
    faults: RefCell<BTreeMap<&'static str, Option<String>>>,
}

impl GradingFolder {
    /// Writes what has changed of the workbook, and builds the stages of the exercises by the words
    /// by which students' files are built: so for each of them only the file itself is compiled
    /// within the student's limit of time. A stage that does not build is printed, and the others are graded.
    pub fn new(
        course: &'static [Exercise],
        exercises: &[&'static Exercise],
    ) -> Result<Self, String> {
        let folder = files::workspace().join("target/grading");
        let folder = Self {
            sandbox: Sandbox { folder },
            faults: RefCell::default(),
        };
        let root = folder.in_workbook("");
        let target = folder.sandbox.folder.join("target");
        if !target.exists() {
            eprintln!("First the workbook is built for grading, which takes about a minute.");
        }
        for folder in [&root, &target] {
            fs::create_dir_all(folder).map_err(with_path(folder))?;
        }
        let lock = folder.lock()?;
        update(&root, &workbook_to_grade(course)?).map_err(with_path(&root))?;
        // In the sandbox, Cargo downloads nothing.
        let mut cargo = Command::new("cargo");
        cargo.args(["fetch", "--quiet", "--target", "host-tuple"]);
        output_of(cargo.current_dir(&root))?;
        for e in exercises.chunk_by(|a, b| a.stage == b.stage) {
            if let Some(fault) = folder.fault(e[0])? {
                eprintln!("{}: the starter of {} {fault}", e[0].stage, e[0].name);
            }
        }
        drop(lock);
        Ok(folder)
    }

    /// Why the starter of an exercise does not build, if it does not.
    pub fn fault(&self, e: &'static Exercise) -> Result<Option<String>, String> {
        if let Some(fault) = self.faults.borrow().get(e.name) {
            return Ok(fault.clone());
        }
        let text = &starter(e)?;
        let built = self.build(&[StudentFile { exercise: e, text }], Limits::All)?;
        let fault =
            (built.end != End::Success).then(|| self.sandbox.words(&built, "does not compile"));
        self.faults.borrow_mut().insert(e.name, fault.clone());
        Ok(fault)
    }

    /// The exercises of which it is known that their starters do not build.
    pub fn faulty(&self) -> Vec<&'static str> {
        let faults = self.faults.borrow();
        let faulty = faults.iter().filter(|(_, fault)| fault.is_some());
        faulty.map(|(name, _)| *name).collect()
    }

    /// Waits until no other grading uses the folder. The lock ends with the file.
    pub fn lock(&self) -> Result<File, String> {
        let path = self.sandbox.folder.join("lock");
        let lock = File::create(&path).map_err(with_path(&path))?;
        lock.lock().map_err(with_path(&path))?;
        Ok(lock)
    }

    /// The place of a file in the workbook.
    fn in_workbook(&self, path: &str) -> PathBuf {
        self.sandbox.folder.join("workbook").join(path)
    }

    /// Builds a program of files of one student for exercises of one stage. They are there only meanwhile, and their
    /// program until the next one is built, which shall find none of them.
    pub fn build(&self, files: &[StudentFile], limits: Limits) -> Result<Ended, String> {
        let deps = self.sandbox.folder.join("target/debug/deps");
        remove_programs(&deps).map_err(with_path(&deps))?;
        let mut build: Vec<_> = ["cargo", "--offline", "--quiet"].map(str::to_owned).into();
        let names: Vec<_> = files.iter().map(|file| file.exercise.name).collect();
        let stage = files.first().map_or("", |file| file.exercise.stage);
        build.extend(learn::arguments(stage, &names));
        let path = |name| self.in_workbook(&format!("{stage}/exercises/{name}.rs"));
        for file in files {
            let path = path(file.exercise.name);
            fs::write(&path, file.text).map_err(with_path(&path))?;
        }
        let built = self.sandbox.run(limits, Place::Workbook, build);
        for name in names {
            let path = path(name);
            fs::remove_file(&path).map_err(with_path(&path))?;
        }
        built
    }
}

/// Removes the programs of students' files.
fn remove_programs(deps: &Path) -> io::Result<()> {
    if !deps.exists() {
        return Ok(());
    }
    for file in fs::read_dir(deps)? {
        let file = file?;
        if file
            .file_name()
            .as_encoded_bytes()
            .starts_with(b"exercises-")
        {
            fs::remove_file(file.path())?;
        }
    }
    Ok(())
}

/// A workbook in which nothing is that a student's program could print: no solution, and questions without answers.
fn workbook_to_grade(course: &'static [Exercise]) -> Result<Workbook, String> {
    let handout = Handout {
        without_solutions: true,
        ..Handout::default()
    };
    let mut workbook = handout.workbook(course)?;
    for e in course {
        let questions = record(e)?.without_answers();
        workbook.insert(record_file(e), questions.to_string().into());
    }
    Ok(workbook)
}

/// Writes the files that differ, and removes those that are in no workbook: of others Cargo sees by
/// their times that they are built.
fn update(root: &Path, workbook: &Workbook) -> io::Result<()> {
    for path in paths_in(root, root)? {
        if !workbook.contains_key(&path) {
            fs::remove_file(root.join(&path))?;
        }
    }
    for (path, bytes) in workbook {
        let file = root.join(path);
        if fs::read(&file).is_ok_and(|old| old == *bytes) {
            continue;
        }
        if let Some(folder) = file.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(&file, bytes)?;
    }
    Ok(())
}
