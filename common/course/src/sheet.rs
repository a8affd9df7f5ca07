//! Judges programs by the pictures that they draw for open sheets, each run in the sandbox.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::time::Instant;

use ::sheet::{Drawn, Facts, MARKED, Picture, Run, Sheet, last_words, no_picture};
use learn::files::with_path;
use learn::sheet::{find, read_all};

use crate::collected::Student;
use crate::grading_folder::GradingFolder;
use crate::handed_file::HandedFile;
use crate::outcome::{Judged, Outcome, State};
use crate::own_program::{self, OwnProgram};
use crate::sandbox::{End, Limits, Place, Sandbox};

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

/// Judges the programs that a student has handed in for sheets. Their pictures are kept in the folder of the results.
pub fn judge_all(
    student: &Student,
    files: &[HandedFile],
    sheets: &[Sheet],
    folder: &GradingFolder,
    output: Option<&Path>,
) -> Result<Vec<Judged>, String> {
    let all = read_all()?;
    let not_kept = folder.sandbox.folder.join("kept");
    let mut results = Vec::new();
    for sheet in sheets {
        let found = own_program::find(files, sheet, &all);
        let (file, outcome) = match found {
            Ok(None) => (
                String::new(),
                Outcome::without_answers(State::NotHandedIn, ""),
            ),
            Ok(Some(program)) => {
                let root = output.unwrap_or(&not_kept);
                let inner = format!("pictures/{}/{}", student.file_name, sheet.name);
                let judged = judge_program(&program, sheet, folder, &root.join(inner));
                let mut outcome = judged.unwrap_or_else(|fault| {
                    eprintln!("{}: {fault}", program.folder);
                    needs_a_look(&folder.sandbox.without_place(&fault))
                });
                if output.is_some() {
                    let root = format!("{}/", root.display());
                    outcome.message = outcome.message.replace(&root, "");
                }
                (program.folder, outcome)
            }
            Err(why) => (String::new(), needs_a_look(&why)),
        };
        results.push(Judged {
            stage: "sheet",
            name: sheet.name.clone(),
            file,
            outcome,
        });
    }
    Ok(results)
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
    let (built, name) = program.build(folder)?;
    let words = sandbox.words(&built, "does not compile");
    match built.end {
        End::Success => {}
        // It says nothing about the program: the computer may have been busy.
        End::Limit(_) => return Err(format!("while it was compiled: {words}")),
        _ => return Ok(Outcome::without_answers(State::Wrong, &words)),
    }
    let executable = learn::find_program(&built.output, learn::Kind::Bin(&name))?;
    empty(kept)?;
    // By scene and samples.
    let mut pictures = BTreeMap::new();
    let mut fault = None;
    let judgement = ::sheet::judge(sheet, Facts::All, &mut |picture, run| {
        let drawn = draw(sandbox, &executable, picture, run, kept).unwrap_or_else(|error| {
            fault = Some(error.clone());
            Err(error)
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
        let marked = file.with_extension(MARKED);
        files.push(file);
        if marked.exists() {
            files.push(marked);
        }
    }
    Ok(Outcome {
        state,
        message: format!("{passed} of {all} facts hold\n{report}"),
        fraction: passed as f64 / all as f64,
        mistake: judgement.mistake(),
        pictures: files,
        unnamed: Vec::new(),
    })
}

/// An empty folder, in which nothing of an earlier program is.
pub fn empty(folder: &Path) -> Result<(), String> {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(with_path(folder))?;
    }
    fs::create_dir_all(folder).map_err(with_path(folder))
}

/// Draws a picture. The outer error is a fault of the grader, the inner one a sentence about the program.
fn draw(
    sandbox: &Sandbox,
    executable: &str,
    picture: &Picture,
    run: &Run,
    kept: &Path,
) -> Result<Result<Drawn, String>, String> {
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
    // The program may write there what it wants: only a plain file of the right name is taken.
    let drawn = sandbox.folder.join("pictures").join(&file);
    if !fs::symlink_metadata(&drawn).is_ok_and(|file| file.is_file()) {
        return Ok(Err(no_picture(None)));
    }
    let file = kept.join(&file);
    fs::copy(&drawn, &file).map_err(with_path(&drawn))?;
    Ok(Ok(Drawn { file, seconds }))
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
