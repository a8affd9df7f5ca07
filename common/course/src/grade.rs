//! `grade`: judges the files of students in a handout without solutions.

use std::fs;
use std::path::PathBuf;

use learn::exercise::{self, Exercise};
use learn::files::with_path;

use crate::exercises;
use crate::grading_folder::GradingFolder;
use crate::handout::Handout;
use crate::judge::judge;
use crate::outcome::{Graded, Judged, Outcome, State};
use crate::own_program;
use crate::results;
use crate::sheet;
use crate::submission::{self, Found, Submission};
use crate::unnamed::Unnamed;

/// Judges what students hand in, with limits
#[derive(clap::Args)]
pub struct Grade {
    /// A folder or zip file of a student, or of all students; without any, only what is needed is
    /// built
    #[arg(value_name = "FOLDER_OR_ZIP")]
    paths: Vec<PathBuf>,
    /// The last stage whose exercises count, such as a04 [default: all stages]
    #[arg(long, value_name = "STAGE")]
    until: Option<String>,
    /// The exercises that count [default: all of the stages]
    #[arg(long, value_name = "NAME,NAME", value_delimiter = ',', value_parser = exercise::find)]
    exercises: Vec<&'static Exercise>,
    /// The open sheets that count; exercises then only if they are named, too
    #[arg(long, value_name = "NAME,NAME", value_delimiter = ',')]
    sheets: Vec<String>,
    /// Also writes results.csv, a text for each student, and a page of all pictures into this folder
    #[arg(long, short, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

impl Grade {
    /// Judges all submissions, prints each, and returns how many there are. It is an error if
    /// something needs a look.
    pub fn run(mut self, course: &'static [Exercise]) -> Result<String, String> {
        if !cfg!(target_os = "linux") {
            let instead = "on Windows use WSL, on macOS a virtual machine or a container";
            return Err(format!("files are judged on Linux only; {instead}"));
        }
        let sheets = sheet::chosen(&self.sheets)?;
        let sets_exercises = sheets.is_empty() || self.until.is_some();
        if self.exercises.is_empty() && sets_exercises {
            self.exercises
                .extend(exercises(course, self.until.as_ref())?);
        }
        self.exercises
            .sort_by_key(|e| course.iter().position(|of| of == *e));
        for path in &self.paths {
            fs::metadata(path).map_err(with_path(path))?;
        }
        let submissions = submission::read(&self.paths, course);
        let submissions = submissions.map_err(|error| format!("a folder: {error}"))?;
        let mut programs = Vec::new();
        if !sheets.is_empty() {
            programs =
                own_program::find(&self.paths).map_err(|error| format!("a folder: {error}"))?;
        }
        let folder = self.prepare(course)?;
        if !sheets.is_empty() {
            own_program::prepare(&folder)?;
        }
        if self.paths.is_empty() {
            let faulty = folder.faulty();
            return if faulty.is_empty() {
                Ok("all is built".to_owned())
            } else {
                Err(format!("these do not build: {}", faulty.join(", ")))
            };
        }
        let (mut graded, mut unnamed) = (Vec::new(), Unnamed::default());
        if !self.exercises.is_empty() {
            for submission in &submissions {
                let student = self.judge_all(submission, &folder, &mut unnamed)?;
                print!("{}", results::text(&student));
                graded.push(student);
            }
        }
        for programs in programs.chunk_by(|a, b| a.student == b.student) {
            let student = sheet::judge_all(programs, &sheets, &folder, self.output.as_deref());
            print!("{}", results::text(&student));
            match graded.iter_mut().find(|other| other.name == student.name) {
                Some(other) => other.results.extend(student.results),
                None => graded.push(student),
            }
        }
        print!("{}", unnamed.list()?);
        let needs_a_look = |judged: &Judged| judged.outcome.state == State::NeedsALook;
        let unclear = graded
            .iter()
            .filter(|student| student.results.iter().any(needs_a_look));
        let unclear: Vec<_> = unclear.map(|student| student.name.clone()).collect();
        if let Some(folder) = &self.output {
            results::write(folder, &graded)?;
        }
        if unclear.is_empty() {
            return Ok(format!("{} submissions are judged", graded.len()));
        }
        Err(format!("these need a look: {}", unclear.join(", ")))
    }

    /// A folder with a handout without solutions, which is built.
    fn prepare(&self, course: &'static [Exercise]) -> Result<GradingFolder, String> {
        let handout = Handout {
            without_solutions: true,
            ..Handout::default()
        };
        GradingFolder::new(&handout.workbook(course)?, &self.exercises)
    }

    /// Judges the files of a student, one after the other.
    fn judge_all(
        &self,
        submission: &Submission,
        folder: &GradingFolder,
        unnamed: &mut Unnamed,
    ) -> Result<Graded, String> {
        let mut results = Vec::new();
        for e in &self.exercises {
            let (mut file, mut about) = (String::new(), String::new());
            let outcome = match submission.find(e) {
                Found::Nothing => Outcome::without_answers(State::NotHandedIn, ""),
                Found::Unclear(why) => Outcome::without_answers(State::NeedsALook, &why),
                Found::File { path, text, note } => {
                    path.clone_into(&mut file);
                    about = note;
                    let outcome = judge(folder, e, text);
                    unnamed.add(e, &submission.name, text, &outcome.unnamed)?;
                    outcome
                }
            };
            results.push(Judged {
                stage: e.stage,
                name: e.name.to_owned(),
                file,
                pictures: Vec::new(),
                note: about,
                outcome,
            });
        }
        Ok(Graded {
            name: submission.name.clone(),
            results,
        })
    }
}
