//! The oracle of the corpus: exact answers by rational arithmetic.
//!
//! A decision is a sign of rational numbers, or of `a + b √d` with rational a, b and d, which squares
//! decide. Digits are those on which two approximations of different accuracy agree.

mod answer;
mod exact;
mod families;
mod question;
mod solve;
mod write;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

use corpus::{Case, Question, Row};

const USAGE: &str = "\
oracle fill       answers the questions of cases.toml and laboratory.toml, and writes them and single.toml
oracle families   writes the generated families of cases.toml anew, then as fill
oracle check      fails if fill would write another answer";

const HEAD: &str = "\
# Rays that broke ray tracers, with exact answers. See README.md beside this file.
# To the extent possible under law, its authors have dedicated it to the public domain: CC0 1.0,
# https://creativecommons.org/publicdomain/zero/1.0/
#
# Numbers are doubles, each as the shortest decimal that is read as the same double. Numbers in quotes are
# exact answers, rounded to 40 significant digits. `cargo run --release --manifest-path
# corpus/oracle/Cargo.toml fill` writes answer, t, normal, condition and margin of every case.
";

const SINGLE_HEAD: &str = "\
# The cases of cases.toml with each number rounded to single precision, and the exact answers of the rounded
# numbers. Written by the oracle; see README.md beside this file, which has its licence, too: CC0 1.0.
";

const LABORATORY_HEAD: &str = "\
# The cases of the stages' laboratories, in the format of cases.toml, with what they expect of two formulas. See
# README.md beside this file, which has its licence, too: CC0 1.0.
#
# `cargo run --release --manifest-path corpus/oracle/Cargo.toml fill` writes answer, t, normal, condition, margin
# and distance of every case.
";

fn main() -> ExitCode {
    match run() {
        Ok(says) => {
            println!("{says}");
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("oracle: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<String, String> {
    let command = env::args().nth(1).unwrap_or_default();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let paths = ["cases.toml", "single.toml", "laboratory.toml"].map(|name| folder.join(name));
    let text = fs::read_to_string(&paths[0]).map_err(|error| format!("cases.toml: {error}"))?;
    let mut questions = corpus::read_questions(&text).map_err(|error| error.to_string())?;
    if command == "families" {
        questions.retain(|question| !families::NAMES.contains(&question.family.as_str()));
        questions.extend(families::questions());
    }
    checked(&questions)?;
    if !["fill", "families", "check"].contains(&command.as_str()) {
        return Err(format!("no command was given\n{USAGE}"));
    }
    let singles: Vec<Question> = questions.iter().filter_map(answer::single).collect();
    let texts = [
        write::file(HEAD, &answers(questions)),
        write::file(SINGLE_HEAD, &answers(singles)),
        laboratory(&paths[2])?,
    ];
    let mut says = String::new();
    for (path, text) in paths.iter().zip(texts) {
        says += &kept(path, &text, command == "check")?;
    }
    Ok(says)
}

/// The text of the rows of the laboratories, whose questions are in the file.
fn laboratory(path: &PathBuf) -> Result<String, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("laboratory.toml: {error}"))?;
    let rows = corpus::read_unanswered_rows(&text).map_err(|error| error.to_string())?;
    let questions: Vec<Question> = rows.iter().map(|(question, _)| question.clone()).collect();
    unique(&questions)?;
    let answer = |(question, expected)| answer::row(question, expected);
    let rows: Vec<Row> = rows.into_iter().map(answer).collect();
    Ok(write::rows(LABORATORY_HEAD, &rows))
}

/// Compares a file with what it should be, or writes it.
fn kept(path: &PathBuf, text: &str, is_check: bool) -> Result<String, String> {
    let count = text.matches("[[case]]").count();
    let name = path.file_name().unwrap_or_default().display().to_string();
    if is_check {
        let before = fs::read_to_string(path).map_err(|error| format!("{name}: {error}"))?;
        if let Some((a, b)) = before.lines().zip(text.lines()).find(|(a, b)| a != b) {
            return Err(format!("{name} has\n{a}\ninstead of\n{b}"));
        }
        if before != text {
            return Err(format!("{name} has another number of lines"));
        }
    } else {
        fs::write(path, text).map_err(|error| format!("{name}: {error}"))?;
    }
    Ok(format!("{name}: {count} cases\n"))
}

/// Refuses questions that have no exact answer, or the same id.
fn checked(questions: &[Question]) -> Result<(), String> {
    unique(questions)?;
    for question in questions {
        answer::validate(question).map_err(|problem| format!("case {}: {problem}", question.id))?;
    }
    Ok(())
}

/// Refuses questions of the same id.
fn unique(questions: &[Question]) -> Result<(), String> {
    let mut ids: Vec<&str> = questions
        .iter()
        .map(|question| question.id.as_str())
        .collect();
    ids.sort_unstable();
    let twice = ids.iter().zip(ids.iter().skip(1)).find(|(a, b)| a == b);
    if let Some((id, _)) = twice {
        return Err(format!("the id {id} is used twice"));
    }
    Ok(())
}

fn answers(questions: Vec<Question>) -> Vec<Case> {
    questions.into_iter().map(answer::answer).collect()
}
