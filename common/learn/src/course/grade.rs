//! `grade`: judges the files of students in a handout without solutions.
//!
//! The student's program runs in a sandbox, and prints its answers and its picture. The grader
//! compares them with the recorded ones of its own workbook: so an exit code is no verdict.

use std::fs;
use std::path::{Path, PathBuf};

use ::exercise::{PictureVerdict, Record, StudentOutput, expected_picture, pictured, verdict};

use super::handout::Handout;
use super::result_file::{self, FORMATS};
use super::sandbox::Sandbox;
use super::{exercises, submission};
use crate::exercise::{self, Exercise};
use crate::files::{self, failed};
use crate::judgement;
use crate::lacking::lacking;

/// A submission, and for each exercise nothing if it is right, or the message to the student.
pub struct Graded {
    pub name: String,
    pub results: Vec<(&'static Exercise, Result<(), String>)>,
}

/// For lecturers: judges submissions, with limits
#[derive(clap::Args)]
pub struct Grade {
    /// Submissions
    #[arg(required = true, value_name = "FOLDER_OR_ZIP")]
    paths: Vec<PathBuf>,
    /// The last stage whose exercises count, as a04 [default: all stages]
    #[arg(long, value_name = "STAGE")]
    until: Option<String>,
    /// The exercises that count [default: all of the stages]
    #[arg(long, value_name = "NAME,NAME", value_delimiter = ',', value_parser = exercise::find)]
    exercises: Vec<&'static Exercise>,
    /// The form of the results
    #[arg(long, default_value = "table", value_parser = FORMATS.map(|(name, ..)| name))]
    format: String,
}

impl Grade {
    pub fn run(mut self, course: &'static [Exercise]) -> Result<String, String> {
        if self.exercises.is_empty() {
            self.exercises
                .extend(exercises(course, self.until.as_ref())?);
        }
        let format = &*self.format;
        if ["gradescope", "classroom50"].contains(&format) && self.paths.len() > 1 {
            return Err(format!("a file for {format} is about one submission"));
        }
        for path in &self.paths {
            fs::metadata(path).map_err(failed(path))?;
        }
        let sandbox = self.prepare(course)?;
        let grade = |path: &PathBuf| {
            let name = path.file_stem().unwrap_or(path.as_os_str());
            let name = name.to_string_lossy().into_owned();
            eprintln!("{name}");
            let judged = |e: &&'static Exercise| (*e, judge(&sandbox, e, path));
            let results = self.exercises.iter().map(judged).collect();
            Graded { name, results }
        };
        let graded: Vec<_> = self.paths.iter().map(grade).collect();
        Ok(result_file::text(format, &graded))
    }

    /// A sandbox with a handout without solutions, which is built.
    fn prepare(&self, course: &'static [Exercise]) -> Result<Sandbox, String> {
        let folder = files::workspace().join("target/grading");
        let handout = Handout {
            folder: folder.join("workbook"),
            until: self.exercises.iter().map(|e| e.stage.to_owned()).max(),
            without_solutions: true,
        };
        // If it remains, it is no new folder for a handout.
        let _ = fs::remove_dir_all(&handout.folder);
        handout.run(course)?;
        let target = folder.join("target");
        fs::create_dir_all(&target).map_err(failed(&target))?;
        let sandbox = Sandbox { folder };
        let build = "cargo test --offline --quiet --no-run --test exercises";
        sandbox.run("all", build.split(' '), "the handout does not build")?;
        Ok(sandbox)
    }
}

/// Builds and runs a file of a submission, and compares its answers. Each error is a result, so
/// that no submission ends the grading of others.
fn judge(sandbox: &Sandbox, e: &Exercise, submission: &Path) -> Result<(), String> {
    let text = submission::read(submission, e)?;
    if let Some(lacks) = lacking(e, &text) {
        return Err(format!("does not compile: {lacks}"));
    }
    let file = format!("workbook/{}/exercises/{}.rs", e.stage, e.name);
    let file = sandbox.folder.join(file);
    fs::write(&file, text).map_err(failed(&file))?;
    let build = ["cargo", "--offline", "--quiet"].map(str::to_owned);
    let build = build.into_iter().chain(judgement::arguments(e));
    let built = sandbox.run("build", build, "does not compile");
    // The next submission shall not find it.
    fs::remove_file(&file).map_err(failed(&file))?;
    sandbox.run("check", [judgement::program(&built?)?], "not yet")?;

    let output = fs::read(sandbox.output()).map_err(failed(&sandbox.output()))?;
    compare(e, &String::from_utf8_lossy(&output))
        .map_err(|wrong| format!("the program reports success, but its answers say: {wrong}"))
}

/// Compares the answers and the picture in the output of a program with the recorded ones.
fn compare(e: &Exercise, output: &str) -> Result<(), String> {
    let file = format!("{}/exercises/answers/{}.txt", e.stage, e.name);
    let record = Record::read(&files::read(&file)?)?;
    let printed = StudentOutput::read(output);
    let picture = record.picture.as_ref().map(|scene| {
        let expected = expected_picture(&files::workspace(), e.stage, scene);
        match &printed.picture {
            Some(image) => pictured(scene, &expected, image, None),
            None => PictureVerdict {
                is_right: false,
                words: format!("the picture of scene {scene}: it is missing"),
                divergence: None,
            },
        }
    });
    let found = verdict(&record, &printed.answers, picture);
    if found.wrong.is_empty() {
        return Ok(());
    }
    Err(found.wrong.join("\n"))
}
