//! Judges programs by the pictures that they draw for open sheets, each run in the sandbox.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::time::Instant;

use judge::pictures::{
    Drawn, Facts, MARKED_EXTENSION, RequestedPicture, Run, Sheet, ask_facts, last_words, no_picture,
};
use learn::files::{self, with_path};
use learn::sheet::{diagram, find, read_all};

use crate::collected::Student;
use crate::grading_folder::GradingFolder;
use crate::handed_file::HandedFile;
use crate::outcome::{Judged, Outcome, State};
use crate::own_program::{self, OwnProgram};
use crate::sandbox::{End, Limit, Limits, Place, Sandbox, empty};

/// The folder of the workbook's own answers, whose names begin with that of the sheet.
const ANSWERS: &str = "a07-transforms/lab/sheets/src/bin";

/// The sheets of these names.
pub fn chosen(names: &[String]) -> Result<Vec<Sheet>, String> {
    let all = read_all()?;
    for name in names {
        find(&all, name)?;
    }
    Ok(all
        .into_iter()
        .filter(|sheet| names.contains(&sheet.name))
        .collect())
}

/// The files of the workbook's own answers to a sheet.
pub fn answers(sheet: &Sheet) -> Result<Vec<String>, String> {
    let folder = files::workspace().join(ANSWERS);
    let mut answers = Vec::new();
    // No handout has them.
    if folder.exists() {
        for entry in fs::read_dir(&folder).map_err(with_path(&folder))? {
            let file = entry.map_err(with_path(&folder))?.file_name();
            let file = file.to_string_lossy();
            if file.starts_with(&sheet.name) {
                answers.push(format!("{ANSWERS}/{file}"));
            }
        }
    }
    Ok(answers)
}

/// How programs are judged.
pub struct SheetGrading<'a> {
    pub sheets: &'a [Sheet],
    pub folder: &'a GradingFolder,
    /// The folder of the results, which keeps the pictures.
    pub output: Option<&'a Path>,
    /// Whether a program may start by a command of its own.
    pub allows_commands: bool,
}

impl SheetGrading<'_> {
    /// The results of the programs that a student has handed in.
    pub fn results(&self, student: &Student, files: &[HandedFile]) -> Result<Vec<Judged>, String> {
        let all = read_all()?;
        let mut results = Vec::new();
        for sheet in self.sheets {
            let mut judged = Judged {
                stage: "sheet",
                name: sheet.name.clone(),
                file: String::new(),
                files: Vec::new(),
                same_code_as: String::new(),
                outcome: Outcome::without_answers(State::NotHandedIn, ""),
            };
            match own_program::find(files, sheet, &all) {
                Ok(None) => {}
                Ok(Some(program)) => {
                    judged.outcome = self.judge_found(&program, sheet, student);
                    judged.files = program.compared_files();
                    judged.file = program.folder;
                }
                Err(why) => judged.outcome = needs_a_look(&why),
            }
            results.push(judged);
        }
        Ok(results)
    }

    fn judge_found(&self, program: &OwnProgram, sheet: &Sheet, student: &Student) -> Outcome {
        if program.command.is_some() && !self.allows_commands {
            return needs_a_look(
                "its sheet.txt has a command that starts it; such programs run with --allow-commands",
            );
        }
        let not_kept = self.folder.sandbox.folder.join("kept");
        let root = self.output.unwrap_or(&not_kept);
        let inner = format!("pictures/{}/{}", student.file_name, sheet.name);
        let judged = judge_program(program, sheet, self.folder, &root.join(inner));
        let mut outcome = judged.unwrap_or_else(|fault| {
            eprintln!("{}: {fault}", program.folder);
            needs_a_look(&self.folder.sandbox.without_place(&fault))
        });
        if self.output.is_some() {
            let root = format!("{}/", root.display());
            outcome.message = outcome.message.replace(&root, "");
        }
        // It may lack what is left out, and run where that is.
        if outcome.state == State::Wrong && !program.left_out.is_empty() {
            let left_out = program.left_out.join("\n");
            let message = format!("left out: {left_out}\n{}", outcome.message);
            return Outcome {
                pictures: outcome.pictures,
                ..needs_a_look(&message)
            };
        }
        outcome
    }
}

fn needs_a_look(why: &str) -> Outcome {
    Outcome::without_answers(State::NeedsALook, why)
}

/// Builds a program, and asks its pictures all facts. They are kept in a folder. An error is a fault of the grader,
/// or needs a look.
fn judge_program(
    program: &OwnProgram,
    sheet: &Sheet,
    folder: &GradingFolder,
    kept: &Path,
) -> Result<Outcome, String> {
    let _lock = folder.lock()?;
    let sandbox = &folder.sandbox;
    let command = match (program.build(folder)?, &program.command) {
        (Some((built, name)), _) => {
            let words = sandbox.words(&built, "does not compile");
            match built.end {
                End::Success => {}
                // It says nothing about the program: the computer may have been busy.
                End::Limit(_) => return Err(format!("while it was compiled: {words}")),
                _ => return Ok(Outcome::without_answers(State::Wrong, &words)),
            }
            vec![learn::find_program(&built.output, learn::Kind::Bin(&name))?]
        }
        (None, command) => command.clone().unwrap_or_default(),
    };
    empty(kept)?;
    // By scene and samples.
    let mut pictures = BTreeMap::new();
    let mut fault = None;
    let judgement = ask_facts(sheet, Facts::All, &mut |picture, run| {
        let drawn = draw(sandbox, &command, picture, run, kept).map_err(|problem| {
            let (Problem::OfProgram(words) | Problem::OfGrader(words)) = &problem;
            let words = words.clone();
            if matches!(problem, Problem::OfGrader(_)) {
                fault = Some(words.clone());
            }
            words
        })?;
        pictures.insert(run.clone(), drawn.file.clone());
        Ok(drawn)
    });
    if let Some(fault) = fault {
        return Err(format!("the grader fails: {fault}"));
    }
    let (passed, all) = (judgement.passed(), judgement.states.len());
    let state = if passed == all {
        State::Right
    } else {
        State::Wrong
    };
    // The report marks a region in some of them.
    let report = sandbox.without_place(&judgement.report());
    let mut files = Vec::new();
    for file in pictures.into_values() {
        let marked = file.with_extension(MARKED_EXTENSION);
        files.push(file);
        if marked.exists() {
            files.push(marked);
        }
    }
    if let Some(svg) = diagram(&judgement) {
        let file = kept.join("error-against-run-time.svg");
        fs::write(&file, svg).map_err(with_path(&file))?;
        files.push(file);
    }
    Ok(Outcome {
        state,
        message: format!("{}\n{report}", judgement.summary()),
        fraction: passed as f64 / all as f64,
        mistake: judgement.mistake(),
        pictures: files,
        unnamed: Vec::new(),
    })
}

/// Why there is no picture.
#[derive(Debug)]
enum Problem {
    /// A sentence for the student.
    OfProgram(String),
    OfGrader(String),
}

/// Draws a picture by the words that start the program.
fn draw(
    sandbox: &Sandbox,
    command: &[String],
    picture: &RequestedPicture,
    run: &Run,
    kept: &Path,
) -> Result<Drawn, Problem> {
    let (samples, file) = (run.samples.to_string(), run.file());
    let output = format!("../pictures/{file}");
    let asked = [&*run.scene, "--samples", &samples, "-o", &output];
    let words = command.iter().map(String::as_str).chain(asked);
    let seconds = picture.seconds;
    let start = Instant::now();
    let ended = sandbox.run(Limits::Picture { seconds }, Place::Program, words);
    let ended = ended.map_err(Problem::OfGrader)?;
    let seconds = start.elapsed().as_secs_f64();
    match ended.end {
        End::Success => {}
        // Of memory and depth the program has words of its own.
        End::Limit(limit) if limit != Limit::MemoryOrDepth => {
            let words = format!("the program is stopped by the limit of {}", limit.words());
            return Err(Problem::OfProgram(words));
        }
        _ => {
            let words = last_words(&sandbox.without_place(&ended.output));
            return Err(Problem::OfProgram(words));
        }
    }
    // The program may write there what it wants: only a plain file of the right name is taken.
    let drawn = sandbox.folder.join("pictures").join(&file);
    if !fs::symlink_metadata(&drawn).is_ok_and(|file| file.is_file()) {
        return Err(Problem::OfProgram(no_picture(None)));
    }
    let file = kept.join(&file);
    let copied = fs::copy(&drawn, &file).map_err(with_path(&drawn));
    copied.map_err(Problem::OfGrader)?;
    Ok(Drawn { file, seconds })
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use common::{Image, Size, Transfer, picture_file};

    use super::*;

    /// Programs that are shell scripts draw a picture of a pixel, or something else.
    #[test]
    fn only_a_plain_file_of_the_right_name_is_taken() {
        use std::os::unix::fs::PermissionsExt;

        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let everybody = fs::Permissions::from_mode(0o755);
        fs::set_permissions(folder, everybody.clone()).unwrap();
        for name in ["program", "workbook", "target", "kept"] {
            fs::create_dir(folder.join(name)).unwrap();
        }
        let size = Size::new(1, 1).unwrap();
        let pixel = Image::black(size).unwrap().to_rgb8(Transfer::Linear);
        picture_file::save_png(&folder.join("program/pixel.png"), size, &pixel).unwrap();
        let picture = RequestedPicture {
            scene: "a".to_owned(),
            samples: vec![1],
            size,
            seconds: 1,
        };
        let run = Run {
            scene: "a".to_owned(),
            samples: 1,
        };
        let sandbox = Sandbox {
            folder: folder.to_owned(),
        };
        for (script, words) in [
            ("cp pixel.png $5", ""),
            ("cp pixel.png ../pictures/b.png", "writes no picture"),
            ("ln -s /etc/passwd $5", "writes no picture"),
            ("mkfifo $5", "writes no picture"),
            ("while :; do :; done", "stopped by the limit of"),
            ("echo no light >&2; exit 1", "ends with an error: no light"),
        ] {
            let program = folder.join("program/draw.sh");
            fs::write(&program, format!("#!/bin/sh\n{script}\n")).unwrap();
            fs::set_permissions(&program, everybody.clone()).unwrap();
            let command = ["./draw.sh".to_owned()];
            match draw(&sandbox, &command, &picture, &run, &folder.join("kept")) {
                Ok(drawn) => {
                    assert_eq!(words, "", "{script}");
                    assert!(picture_file::open(&drawn.file).is_ok());
                }
                Err(Problem::OfProgram(problem)) => assert!(
                    !words.is_empty() && problem.contains(words),
                    "{script}: {problem}"
                ),
                Err(Problem::OfGrader(fault)) => panic!("{script}: {fault}"),
            }
        }
    }
}
