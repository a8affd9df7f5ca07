//! `prove`: proves exercises by programs that are built as those of students are.
//!
//! Starters are to do, solutions and other right answers are right, the recorded answers are those of the solutions, and
//! known mistakes are wrong and told from each other.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};
use std::{env, fs};

use common::difference::{compare_with_file, largest, leave_pictures};
use common::picture_file;
use judge::answers::{
    BEGUN, MODE, Mode, Record, StudentAnswer, WORDS_MARK, read_answers, read_right_answers,
};
use learn::exercise::{self as exercises, Exercise};
use learn::files::{self, with_path};
use learn::starter;

use crate::exercise_record::{record, record_file};
use crate::sandbox::empty;

/// The folder of the files that a stage's program is built with, instead of the students' own.
const FOLDER: &str = "target/proved";

/// The longest time that a student's check may take.
const MAX_TIME: Duration = Duration::from_secs(10);

/// Proves exercises; with `always` in the variable `INSTA_UPDATE`, records the answers and pictures of the solutions
#[derive(clap::Args)]
pub struct Prove {
    /// The exercises, of which it also shows what students read about known mistakes [default: all]
    #[arg(value_name = "EXERCISE", value_parser = exercises::find)]
    exercises: Vec<&'static Exercise>,
    #[arg(skip)]
    is_shown: bool,
}

/// What does not hold.
type Problems = Vec<String>;

impl Prove {
    /// Proves the exercises, and returns how many there are; an error names all that does not hold.
    pub fn run(mut self, course: &'static [Exercise]) -> Result<String, String> {
        self.is_shown = !self.exercises.is_empty();
        if !self.is_shown {
            self.exercises.extend(course);
        }
        let mut problems = Problems::new();
        for of_stage in self.exercises.chunk_by(|a, b| a.stage == b.stage) {
            problems.extend(self.prove_stage(of_stage)?);
        }
        if problems.is_empty() {
            return Ok(match self.exercises.len() {
                1 => "1 exercise is proved".to_owned(),
                count => format!("{count} exercises are proved"),
            });
        }
        Err(problems.join("\n"))
    }

    fn prove_stage(&self, all: &[&'static Exercise]) -> Result<Problems, String> {
        let mut problems = Problems::new();
        let mut starters = Vec::new();
        let mut solutions = Vec::new();
        for e in all {
            starters.push((*e, starter(e)?));
            solutions.push((*e, files::read(&e.solution_file())?));
        }
        problems.extend(check(&starters, "the starter", |e, program| {
            let judged = ask(program, e, Mode::Student)?;
            match judged.status.code() {
                Some(code) if code == i32::from(BEGUN) => Ok(()),
                _ => Err(format!("must be to do\n{}", words(&judged))),
            }
        })?);
        problems.extend(check(&solutions, "the solution", |e, program| {
            self.prove_answers(e, program)?;
            is_right(e, program)?;
            prove_picture(e)
        })?);
        for way in folders(&format!("{}/exercises/others", all[0].stage))? {
            let mut others = Vec::new();
            for e in all {
                let path = way.join(format!("{}.rs", e.name));
                if path.exists() {
                    others.push((*e, fs::read_to_string(&path).map_err(with_path(&path))?));
                }
            }
            problems.extend(check(&others, &way.display().to_string(), is_right)?);
        }
        Ok(problems)
    }

    /// Compares the recorded answers with those of the solution, or records them, and proves the known mistakes.
    fn prove_answers(&self, e: &Exercise, program: &Path) -> Result<(), String> {
        let recorded = record(e)?;
        let output = ask(program, e, Mode::Mistake)?;
        let printed = String::from_utf8_lossy(&output.stdout);
        let (given, _) = read_answers(&printed);
        let right_answers = read_right_answers(&printed);
        if right_answers.is_empty() {
            return Err(words(&output));
        }
        let record = if is_recording() {
            let (record, messages) = recorded.renewed(right_answers);
            for message in messages {
                println!("{}: {message}", e.name);
            }
            let file = files::workspace().join(record_file(e));
            fs::write(&file, record.to_string()).map_err(with_path(&file))?;
            record
        } else {
            let record = recorded.with_answers(right_answers);
            compare(&files::read(&record_file(e))?, &record.to_string())?;
            record
        };
        self.prove_mistakes(&record, given)
    }

    fn prove_mistakes(&self, record: &Record, given: Vec<StudentAnswer>) -> Result<(), String> {
        let questions: Vec<_> = given.into_iter().map(|given| given.question).collect();
        for mistake in &record.mistakes {
            let verdict = record.prove(mistake, &questions);
            let verdict = verdict.map_err(|problem| {
                format!(
                    "the mistake that overlooks that {}: {problem}",
                    mistake.overlooks
                )
            })?;
            if self.is_shown {
                let known = verdict.known.unwrap_or_default();
                println!("{}\n{known}\n", verdict.wrong.join("\n"));
            }
        }
        Ok(())
    }
}

fn is_recording() -> bool {
    env::var("INSTA_UPDATE").is_ok_and(|update| update == "always")
}

/// Builds a program of the files, and asks it for each exercise whether they are what they should be. An error is that
/// of the build.
fn check(
    files: &[(&'static Exercise, String)],
    what: &str,
    holds: impl Fn(&Exercise, &Path) -> Result<(), String>,
) -> Result<Problems, String> {
    let mut problems = Problems::new();
    if files.is_empty() {
        return Ok(problems);
    }
    let program = build(files).map_err(|error| format!("{what}: {error}"))?;
    for (e, _) in files {
        if let Err(problem) = holds(e, &program) {
            problems.push(format!("{}: {what}: {problem}", e.name));
        }
    }
    Ok(problems)
}

/// The program of these files, for exercises of one stage.
fn build(files: &[(&'static Exercise, String)]) -> Result<PathBuf, String> {
    let folder = files::workspace().join(FOLDER);
    empty(&folder)?;
    let mut names = Vec::new();
    for (e, text) in files {
        let path = folder.join(format!("{}.rs", e.name));
        fs::write(&path, text).map_err(with_path(&path))?;
        names.push(e.name);
    }
    let mut cargo = Command::new("cargo");
    cargo.args(["--quiet", "--locked"]);
    cargo.args(learn::arguments(files[0].0.stage, &names));
    cargo.args(["--cfg", "proved"]);
    let built = output(cargo.current_dir(files::workspace()))?;
    if !built.status.success() {
        return Err(String::from_utf8_lossy(&built.stderr).into_owned());
    }
    let messages = String::from_utf8_lossy(&built.stdout);
    learn::find_program(&messages, learn::Kind::Test).map(PathBuf::from)
}

fn output(command: &mut Command) -> Result<Output, String> {
    let name = command.get_program().to_owned();
    command.output().map_err(with_path(name.as_ref()))
}

/// What a program says of an exercise.
fn ask(program: &Path, e: &Exercise, mode: Mode) -> Result<Output, String> {
    output(Command::new(program).arg(e.name).env(MODE, mode.name()))
}

/// All that a program has said, without the marks of a check's words.
fn words(output: &Output) -> String {
    let all = [&*output.stdout, &*output.stderr].concat();
    String::from_utf8_lossy(&all).replace(WORDS_MARK, "")
}

/// An error if a student who hands this in reads anything but that it is right.
fn is_right(e: &Exercise, program: &Path) -> Result<(), String> {
    let start = Instant::now();
    let judged = ask(program, e, Mode::Student)?;
    let elapsed = start.elapsed();
    if !judged.status.success() {
        return Err(format!("must be right\n{}", words(&judged)));
    }
    if elapsed > MAX_TIME {
        return Err(format!("a check that takes {elapsed:.0?} ends before it"));
    }
    Ok(())
}

/// Compares the lines of the recorded answers with those of the solution.
fn compare(recorded: &str, answers: &str) -> Result<(), String> {
    let mut lines = (1..).zip(recorded.lines().zip(answers.lines()));
    if let Some((line, (old, new))) = lines.find(|(_, (old, new))| old != new) {
        return Err(format!(
            "line {line} of the recorded answers is\n  {old}\nand would be\n  {new}\n\
             if it is right, record it: INSTA_UPDATE=always"
        ));
    }
    if recorded != answers {
        return Err("the recorded answers are incomplete".to_owned());
    }
    Ok(())
}

/// Compares the picture of a solution, which its check has saved, with the one of the book, or records it.
fn prove_picture(e: &Exercise) -> Result<(), String> {
    let stage = e.stage;
    let drawn = files::workspace().join(format!("out/exercises/{stage}-{}.png", e.name));
    let name = format!("{stage}-exercise-{}.png", e.name.replace('_', "-"));
    let shown = files::workspace().join("book/src/pictures").join(name);
    if !shown.exists() {
        return Ok(());
    }
    let open = |path: &Path| picture_file::open(path).map_err(|error| error.to_string());
    let [image, expected] = [open(&drawn)?, open(&shown)?];
    let Err(difference) = compare_with_file(&shown, &image) else {
        return Ok(());
    };
    // Another formula may round a channel differently.
    if largest(&expected, &image).is_some_and(|(_, most)| most <= 1) {
        return Ok(());
    }
    if is_recording() {
        return fs::copy(&drawn, &shown)
            .map(|_| ())
            .map_err(with_path(&shown));
    }
    let scratch = files::workspace().join("out/exercises");
    Err(leave_pictures(&scratch, &shown, &image, &difference))
}

/// The folders in a folder of the workbook, if there is one.
fn folders(path: &str) -> Result<Vec<PathBuf>, String> {
    let path = files::shortest(path);
    if !path.exists() {
        return Ok(Vec::new());
    }
    let entries = fs::read_dir(&path).map_err(with_path(&path))?;
    let mut folders: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    folders.sort();
    Ok(folders)
}
