//! `grade`: judges the files of students in a handout without solutions.

use std::path::PathBuf;

use common::text;
use judge::pictures::Sheet;
use learn::exercise::{self, Exercise};
use learn::{files, with_code};

use crate::collected::Collected;
use crate::copies::{self, WorkbooksCode};
use crate::exercise_grading::outcomes;
use crate::grading_folder::GradingFolder;
use crate::handed_file::HandedFile;
use crate::outcome::{Graded, Judged, Outcome, State};
use crate::own_program;
use crate::results;
use crate::sheet_grading::{self, SheetGrading};
use crate::stages::exercises_until;
use crate::structure::ComparedFile;
use crate::submission::{Found, StudentFile, Submission, names};
use crate::unnamed::Unnamed;

/// Judges what students hand in, with limits
#[derive(clap::Args)]
pub struct Grade {
    /// A folder with a folder or a zip file of each student, or the zip file of one; without any, only what
    /// is needed is built
    #[arg(value_name = "COLLECTED")]
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
    /// Also runs programs that start by a command of their own, the line `program: …` of their sheet.txt
    #[arg(long, requires = "sheets")]
    allow_commands: bool,
    /// Also writes a table, results.xlsx and results.csv, a text for each student, and a page of all pictures into this
    /// folder
    #[arg(long, short, value_name = "FOLDER")]
    output: Option<PathBuf>,
    /// Replaces results in a folder that is not empty
    #[arg(long, requires = "output")]
    replace: bool,
}

impl Grade {
    /// Judges all submissions, prints each, and returns how many there are. It is an error if
    /// something needs a look.
    pub fn run(mut self, course: &'static [Exercise]) -> Result<String, String> {
        if !cfg!(target_os = "linux") {
            let instead = "on Windows use WSL, on macOS a virtual machine or a container";
            return Err(format!("files are judged on Linux only; {instead}"));
        }
        if let Some(folder) = &self.output
            && !self.replace
            && !results::is_free(folder)
        {
            let shown = text::path(folder);
            return Err(format!(
                "{shown} is there and not empty; its files are kept, unless --replace is given"
            ));
        }
        let sheets = sheet_grading::chosen(&self.sheets)?;
        let sets_exercises = sheets.is_empty() || self.until.is_some();
        if self.exercises.is_empty() && sets_exercises {
            self.exercises
                .extend(exercises_until(course, self.until.as_ref())?);
        }
        self.exercises
            .sort_by_key(|e| course.iter().position(|of| of == *e));
        self.exercises.dedup();
        let collected = Collected::read(&self.paths, course)?;
        let folder = GradingFolder::new(course, &self.exercises)?;
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
        if !collected.of_nobody.is_empty() {
            let names = names(collected.of_nobody.into_iter());
            println!("of no student: {names}");
        }
        let programs = SheetGrading {
            sheets: &sheets,
            folder: &folder,
            output: self.output.as_deref(),
            allows_commands: self.allow_commands,
        };
        let (mut graded, mut unnamed) = (Vec::new(), Unnamed::default());
        for student in &collected.students {
            let files = student.files();
            let mut results =
                self.judge_exercises(&student.name, &files, course, &folder, &mut unnamed)?;
            results.extend(programs.results(student, &files)?);
            let student = Graded {
                name: student.name.clone(),
                file_name: student.file_name.clone(),
                results,
            };
            print!("{}", results::text(&student));
            graded.push(student);
        }
        print!("{}", unnamed.list()?);
        let copies = copies::mark(&mut graded, &self.workbooks_code(&sheets)?);
        if !copies.is_empty() {
            println!("the same code but for names:\n{}", copies.join("\n"));
        }
        let needs_a_look = |judged: &Judged| judged.outcome.state == State::NeedsALook;
        let unclear = graded
            .iter()
            .filter(|student| student.results.iter().any(needs_a_look));
        let unclear: Vec<_> = unclear.map(|student| student.name.clone()).collect();
        if let Some(folder) = &self.output {
            results::write(folder, &graded)?;
            println!("the results are in {}", text::path(folder));
        }
        if unclear.is_empty() {
            return Ok(match graded.len() {
                1 => "1 submission is judged".to_owned(),
                count => format!("{count} submissions are judged"),
            });
        }
        Err(format!("these need a look: {}", unclear.join(", ")))
    }

    /// The workbook's own code of what counts, by the names of exercises and sheets.
    fn workbooks_code(&self, sheets: &[Sheet]) -> Result<WorkbooksCode, String> {
        let mut code = WorkbooksCode::default();
        for e in &self.exercises {
            let solution = files::read(&e.solution_file())?;
            code.add(e.name, &with_code(&solution)?);
        }
        for sheet in sheets {
            for answer in sheet_grading::answers(sheet)? {
                code.add(&sheet.name, &files::read(&answer)?);
            }
        }
        Ok(code)
    }

    /// Judges the files of a student, those of a stage together.
    fn judge_exercises(
        &self,
        student: &str,
        files: &[HandedFile],
        course: &'static [Exercise],
        folder: &GradingFolder,
        unnamed: &mut Unnamed,
    ) -> Result<Vec<Judged>, String> {
        let submission = Submission::new(files, course);
        let mut results = Vec::new();
        for of_stage in self.exercises.chunk_by(|a, b| a.stage == b.stage) {
            let (mut found, mut files) = (Vec::new(), Vec::new());
            for &exercise in of_stage {
                let file = submission.find(exercise);
                if let Found::File { text, .. } = file {
                    files.push(StudentFile { exercise, text });
                }
                found.push((exercise, file));
            }
            let mut judged = outcomes(folder, &files);
            for (e, found) in found {
                let (mut file, mut compared) = (String::new(), Vec::new());
                let outcome = match (found, judged.remove(e.name)) {
                    (Found::File { path, text }, Some(outcome)) => {
                        file = path;
                        compared.extend(ComparedFile::read(&format!("{}.rs", e.name), text));
                        unnamed.add(e, student, text, &outcome.unnamed)?;
                        outcome
                    }
                    (Found::Unclear(why), _) => Outcome::without_answers(State::NeedsALook, &why),
                    _ => Outcome::without_answers(State::NotHandedIn, ""),
                };
                results.push(Judged {
                    stage: e.stage,
                    name: e.name.to_owned(),
                    file,
                    files: compared,
                    same_code_as: String::new(),
                    outcome,
                });
            }
        }
        Ok(results)
    }
}
