//! Judges programs by the pictures that they draw for open sheets, each run in the sandbox.

use std::fs;
use std::io;
use std::path::Path;
use std::time::Instant;

use ::sheet::{Drawn, Facts, Judgement, Picture, Run, Sheet, last_words, no_picture};
use learn::files::with_path;
use learn::sheet::{find, read_all};

use crate::grading_folder::GradingFolder;
use crate::outcome::{Judged, Outcome, State};
use crate::own_program::OwnProgram;
use crate::results::file_name;
use crate::sandbox::{End, Limits, Place, Sandbox};

/// The sheets of these names.
pub fn chosen(names: &[String]) -> Result<Vec<Sheet>, String> {
    let mut sheets = Vec::new();
    for name in names {
        find(&read_all()?, name)?;
        sheets.extend(read_all()?.into_iter().filter(|sheet| sheet.name == *name));
    }
    Ok(sheets)
}

/// Judges the programs of a student. Their pictures are kept in the folder of the results.
pub fn judge_all(
    student: &str,
    programs: &[OwnProgram],
    sheets: &[Sheet],
    folder: &GradingFolder,
    output: Option<&Path>,
) -> Vec<Judged> {
    let mut results = Vec::new();
    for sheet in sheets {
        let kept = match output {
            Some(output) => output
                .join("pictures")
                .join(file_name(student))
                .join(&sheet.name),
            None => folder.sandbox.folder.join("kept"),
        };
        results.push(judge_sheet(programs, sheet, folder, &kept, output));
    }
    results
}

/// Judges the program that a student has handed in for a sheet.
fn judge_sheet(
    programs: &[OwnProgram],
    sheet: &Sheet,
    folder: &GradingFolder,
    kept: &Path,
    output: Option<&Path>,
) -> Judged {
    let mut judged = Judged {
        stage: "sheet",
        name: sheet.name.clone(),
        file: String::new(),
        pictures: Vec::new(),
        outcome: Outcome::without_answers(State::NotHandedIn, ""),
    };
    let is_for =
        |program: &&OwnProgram| program.sheets.contains(&sheet.name) || program.problem.is_some();
    let needs_a_look = |why: &str| Outcome::without_answers(State::NeedsALook, why);
    let mut found = programs.iter().filter(is_for);
    let Some(program) = found.next() else {
        return judged;
    };
    judged.file.clone_from(&program.folder);
    let others = found.count();
    judged.outcome = if let Some(problem) = &program.problem {
        needs_a_look(problem)
    } else if others > 0 {
        needs_a_look(&format!(
            "there are {} programs for this sheet; hand in one",
            others + 1
        ))
    } else {
        judge_program(program, sheet, folder, kept).unwrap_or_else(|fault| {
            eprintln!("{}: {fault}", program.folder);
            needs_a_look(&folder.sandbox.without_place(&fault))
        })
    };
    if let Some(output) = output {
        judged.outcome.message = judged
            .outcome
            .message
            .replace(&format!("{}/", output.display()), "");
        judged.pictures = pictures_in(kept, output);
    }
    judged
}

/// The paths of kept pictures, from the folder of the results.
fn pictures_in(kept: &Path, output: &Path) -> Vec<String> {
    let mut paths = Vec::new();
    for entry in fs::read_dir(kept).into_iter().flatten().flatten() {
        let path = entry.path();
        let path = path.strip_prefix(output).unwrap_or(&path);
        paths.push(path.to_string_lossy().into_owned());
    }
    paths.sort();
    paths
}

/// Builds a program, and asks its pictures all facts. An error is a fault of the grader, or needs a look.
fn judge_program(
    program: &OwnProgram,
    sheet: &Sheet,
    folder: &GradingFolder,
    kept: &Path,
) -> Result<Outcome, String> {
    let _lock = folder.lock()?;
    let sandbox = &folder.sandbox;
    if kept.exists() {
        fs::remove_dir_all(kept).map_err(with_path(kept))?;
    }
    fs::create_dir_all(kept).map_err(with_path(kept))?;
    let built = program.build(folder)?;
    let words = sandbox.words(&built, "does not compile");
    match built.end {
        End::Success => {}
        // It says nothing about the program: the computer may have been busy.
        End::Limit(_) => return Err(format!("while it was compiled: {words}")),
        _ => return Ok(Outcome::without_answers(State::Wrong, &words)),
    }
    let executable = learn::find_program(&built.output, "bin")?;
    let mut fault = None;
    let judgement = ::sheet::judge(sheet, Facts::All, &mut |picture, run| {
        let drawn = draw(sandbox, &executable, picture, run, kept);
        drawn.unwrap_or_else(|error| {
            fault = Some(error.clone());
            Err(error)
        })
    });
    if let Some(fault) = fault {
        return Err(format!("the grader fails: {fault}"));
    }
    Ok(outcome(&judgement, sandbox))
}

fn outcome(judgement: &Judgement, sandbox: &Sandbox) -> Outcome {
    let (passed, all) = (judgement.passed(), judgement.states.len());
    let state = if passed == all {
        State::Right
    } else {
        State::Wrong
    };
    let report = sandbox.without_place(&judgement.report());
    Outcome {
        state,
        message: format!("{passed} of {all} facts hold\n{report}"),
        fraction: passed as f64 / all as f64,
        mistake: judgement.mistake(),
        unnamed: Vec::new(),
    }
}

/// Draws a picture. The outer error is a fault of the grader, the inner one a sentence about the program.
fn draw(
    sandbox: &Sandbox,
    executable: &str,
    picture: &Picture,
    run: &Run,
    kept: &Path,
) -> Result<Result<Drawn, String>, String> {
    // The program may write here what it wants: only a plain file of the right name is taken, and nothing stays.
    let inbox = sandbox.folder.join("pictures");
    if inbox.exists() {
        fs::remove_dir_all(&inbox).map_err(with_path(&inbox))?;
    }
    fs::create_dir_all(&inbox).map_err(with_path(&inbox))?;
    open_to_everybody(&inbox).map_err(with_path(&inbox))?;

    let (samples, file) = (run.samples.to_string(), run.file());
    let output = format!("../pictures/{file}");
    let words = [executable, &run.scene, "--samples", &samples, "-o", &output];
    let seconds = picture.seconds;
    let start = Instant::now();
    let ended = sandbox.run(Limits::Picture { seconds }, Place::Program, words)?;
    let seconds = start.elapsed().as_secs_f64();
    match ended.end {
        End::Success => {}
        End::Limit(of) if !of.starts_with("memory") => {
            return Ok(Err(format!("the program is stopped by the limit of {of}")));
        }
        _ => return Ok(Err(last_words(&sandbox.without_place(&ended.output)))),
    }
    let drawn = inbox.join(&file);
    if !fs::symlink_metadata(&drawn).is_ok_and(|file| file.is_file()) {
        return Ok(Err(no_picture(None)));
    }
    let file = kept.join(&file);
    fs::copy(&drawn, &file).map_err(with_path(&drawn))?;
    Ok(Ok(Drawn { file, seconds }))
}

/// In the sandbox a program runs as nobody.
#[cfg(unix)]
fn open_to_everybody(folder: &Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;

    fs::set_permissions(folder, fs::Permissions::from_mode(0o777))
}

#[cfg(not(unix))]
fn open_to_everybody(_: &Path) -> io::Result<()> {
    Ok(())
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
        let picture = Picture {
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
            let drawn = draw(&sandbox, "./draw.sh", &picture, &run, &folder.join("kept"));
            match drawn.unwrap() {
                Ok(drawn) => {
                    assert_eq!(words, "", "{script}");
                    assert!(picture_file::open(&drawn.file).is_ok());
                }
                Err(problem) => assert!(
                    !words.is_empty() && problem.contains(words),
                    "{script}: {problem}"
                ),
            }
        }
    }
}
