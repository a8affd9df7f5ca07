//! `grade`: judges the files of students in a handout without solutions.

use std::fs;
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use super::exercises;
use super::grading_folder::GradingFolder;
use super::handout::Handout;
use super::judge::judge;
use super::outcome::{Graded, Judged, Outcome, State, points};
use super::results::{self, Format};
use super::submission::{self, COPIES, Found, Holds, Submission};
use crate::exercise::{self, Exercise};
use crate::files::with_path;

/// For lecturers: judges submissions, with limits
#[derive(clap::Args)]
pub struct Grade {
    /// Submissions, or exports of Moodle, ILIAS, Canvas, Blackboard and Google Classroom; without
    /// any, what is needed is built
    #[arg(value_name = "FOLDER_OR_ZIP")]
    paths: Vec<PathBuf>,
    /// Each folder and each zip file in the given ones is the submission of a student
    #[arg(long)]
    class: bool,
    /// The last stage whose exercises count, such as a04 [default: all stages]
    #[arg(long, value_name = "STAGE")]
    until: Option<String>,
    /// The exercises that count [default: all of the stages]
    #[arg(long, value_name = "NAME,NAME", value_delimiter = ',', value_parser = exercise::find)]
    exercises: Vec<&'static Exercise>,
    /// The points for exercises [default: 1 each]
    #[arg(long, value_name = "NAME=POINTS,NAME=POINTS", value_delimiter = ',', value_parser = weight)]
    weights: Vec<Weight>,
    /// Gives a part of the points, for the fraction of right answers
    #[arg(long)]
    partial: bool,
    /// How many files are judged at the same time
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=64))]
    jobs: u8,
    /// The form of the results
    #[arg(long, default_value = "table")]
    format: Format,
    /// Also writes the results of the class into a folder, in each form for a class
    #[arg(long, short, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

/// The points for an exercise.
#[derive(Clone)]
struct Weight {
    exercise: &'static Exercise,
    points: f64,
}

/// Reads `NAME=POINTS`.
fn weight(text: &str) -> Result<Weight, String> {
    let (name, points) = text.split_once('=').ok_or("it is NAME=POINTS")?;
    let number: f64 = points
        .parse()
        .map_err(|_| format!("{points} is no number"))?;
    if !(0.01..=1000.0).contains(&number) {
        return Err(format!("{points} is not between 0.01 and 1000"));
    }
    Ok(Weight {
        exercise: exercise::find(name)?,
        points: (number * 100.0).round() / 100.0,
    })
}

/// A file that is to be judged: the numbers of its submission and its exercise, and its text.
struct Task<'a> {
    submission: usize,
    exercise: usize,
    text: &'a str,
}

impl Grade {
    /// Judges all submissions, and returns the results. It is an error if something was not judged;
    /// then they are printed before.
    pub fn run(mut self, course: &'static [Exercise]) -> Result<String, String> {
        if !cfg!(target_os = "linux") {
            let instead = "on Windows use WSL, on macOS a virtual machine or a container";
            return Err(format!("files are judged on Linux only; {instead}"));
        }
        if self.exercises.is_empty() {
            self.exercises
                .extend(exercises(course, self.until.as_ref())?);
        }
        let holds = self.holds()?;
        self.check_points()?;
        for path in &self.paths {
            fs::metadata(path).map_err(with_path(path))?;
        }
        let submissions = submission::read(&self.paths, holds, course);
        let submissions = submissions.map_err(|error| format!("a folder: {error}"))?;
        if self.format.is_about_one() && submissions.len() > 1 {
            let format = self.format.name();
            return Err(format!("a file for {format} is about one submission"));
        }
        let folders = self.prepare(course)?;
        if self.paths.is_empty() {
            return Ok("all is built".to_owned());
        }
        let graded = self.graded(&submissions, &folders);
        if let Some(folder) = &self.output {
            results::write_all(folder, &graded)?;
        }
        let text = results::text(self.format, &graded)?;
        // The end of the line is printed behind it.
        let text = text.strip_suffix('\n').unwrap_or(&text).to_owned();
        match not_judged(&graded) {
            None => Ok(text),
            Some(names) => {
                crate::print(&text)?;
                Err(names)
            }
        }
    }

    /// What the folders and zip files hold.
    fn holds(&self) -> Result<Holds, String> {
        let format = self.format.name();
        match (self.class, self.format.is_about_one()) {
            (true, true) => Err(format!("a file for {format} is about one submission")),
            (true, false) => Ok(Holds::Class),
            (false, true) => Ok(Holds::OneStudent),
            (false, false) => Ok(Holds::Export),
        }
    }

    /// An error if the points cannot be written in the format.
    fn check_points(&self) -> Result<(), String> {
        let are_whole = self
            .weights
            .iter()
            .all(|weight| weight.points.fract() == 0.0);
        if self.format == Format::Classroom50 && (self.partial || !are_whole) {
            return Err("a file for classroom50 has whole points only".to_owned());
        }
        for weight in &self.weights {
            if !self.exercises.contains(&weight.exercise) {
                let name = weight.exercise.name;
                return Err(format!("{name} has points, but does not count"));
            }
        }
        Ok(())
    }

    /// The points for a right solution of an exercise.
    fn most(&self, e: &Exercise) -> f64 {
        let weight = self.weights.iter().rfind(|weight| weight.exercise == e);
        weight.map_or(1.0, |weight| weight.points)
    }

    /// A folder for each job, with a handout without solutions, which is built.
    fn prepare(&self, course: &'static [Exercise]) -> Result<Vec<GradingFolder>, String> {
        let handout = Handout {
            until: self.exercises.iter().map(|e| e.stage.to_owned()).max(),
            without_solutions: true,
            ..Handout::default()
        };
        let workbook = handout.workbook(course)?;
        let mut folders = Vec::new();
        for _ in 0..self.jobs {
            let folder = GradingFolder::take()?;
            folder.prepare(&workbook)?;
            folders.push(folder);
        }
        Ok(folders)
    }

    /// Judges all files, each in one of the folders.
    fn graded(&self, submissions: &[Submission], folders: &[GradingFolder]) -> Vec<Graded> {
        let mut graded = Vec::new();
        let mut tasks = Vec::new();
        for (number, submission) in submissions.iter().enumerate() {
            let mut results = Vec::new();
            for (exercise, e) in self.exercises.iter().enumerate() {
                let mut file = String::new();
                let outcome = match submission.find(e) {
                    Found::Nothing => Outcome::not_handed_in(),
                    Found::Unclear(why) => Outcome::needs_a_look(&why),
                    Found::File { path, text } => {
                        path.clone_into(&mut file);
                        tasks.push(Task {
                            submission: number,
                            exercise,
                            text,
                        });
                        Outcome::needs_a_look("nobody has judged it")
                    }
                };
                results.push(Judged {
                    exercise: e,
                    file,
                    outcome,
                    most: self.most(e),
                    points: 0.0,
                });
            }
            let name = submission.name.clone();
            graded.push(Graded { name, results });
        }
        for (task, outcome) in self.judge_all(&tasks, submissions, folders) {
            let judged = &mut graded[task.submission].results[task.exercise];
            judged.points = points(&outcome, judged.most, self.partial);
            judged.outcome = outcome;
        }
        graded
    }

    /// Judges files at the same time, one in each folder.
    fn judge_all<'a>(
        &self,
        tasks: &'a [Task<'a>],
        submissions: &[Submission],
        folders: &[GradingFolder],
    ) -> Vec<(&'a Task<'a>, Outcome)> {
        let next = AtomicUsize::new(0);
        let outcomes = Mutex::new(Vec::new());
        thread::scope(|scope| {
            for folder in folders {
                let work = || {
                    while let Some(task) = tasks.get(next.fetch_add(1, Ordering::Relaxed)) {
                        let e = self.exercises[task.exercise];
                        let outcome = judge(folder, e, task.text);
                        let name = &submissions[task.submission].name;
                        eprintln!("{name}: {} {}", e.name, outcome.state.words());
                        if let Ok(mut outcomes) = outcomes.lock() {
                            outcomes.push((task, outcome));
                        }
                    }
                };
                scope.spawn(work);
            }
        });
        outcomes.into_inner().unwrap_or_default()
    }
}

/// What was not judged, and why.
fn not_judged(graded: &[Graded]) -> Option<String> {
    let mut lines = Vec::new();
    for submission in graded {
        let mut names = Vec::new();
        let mut reasons = Vec::new();
        for judged in &submission.results {
            if judged.outcome.state == State::NeedsALook {
                names.push(judged.exercise.name);
                reasons.push(&*judged.outcome.message);
            }
        }
        if reasons.is_empty() {
            continue;
        }
        reasons.dedup();
        let (name, why) = (&submission.name, reasons.join("; "));
        if names.len() == submission.results.len() {
            lines.push(format!("  {name}: {why}"));
        } else {
            lines.push(format!("  {name}: {why} ({})", names.join(", ")));
        }
    }
    if lines.is_empty() {
        return None;
    }
    let lines = lines.join("\n");
    let mut text = format!("not all is judged:\n{lines}");
    if lines.contains(COPIES) {
        text += "\nif each folder or zip file in a given one is a student's, add --class";
    }
    Some(text)
}
