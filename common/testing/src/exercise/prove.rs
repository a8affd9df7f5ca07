//! `prove`: proves the checks of a stage by solutions and usual mistakes.

use std::process::ExitCode;

use super::check::{Findings, Pictures};
use super::{Exercise, Wrong, locked};

/// Number of wrong solutions that each exercise has at least.
const MIN_WRONG: usize = 3;

/// Proves that the checks accept all solutions and refuse all wrong ones.
///
/// As for every test, a part of a name selects exercises, and the flags of `cargo test`
/// are allowed. For a selected exercise, the messages of its wrong solutions are
/// printed, and the picture of the solution is saved.
#[must_use]
pub fn prove(stage: &str, exercises: &[Exercise]) -> ExitCode {
    let names = names(std::env::args().skip(1));
    let named = !names.is_empty();
    let is_wanted = |e: &&Exercise| !named || names.iter().any(|name| e.name.contains(name));
    let wanted: Vec<_> = exercises.iter().filter(is_wanted).collect();
    if std::env::args().any(|argument| argument == "--list") {
        for exercise in wanted {
            println!("{}: test", exercise.name);
        }
        return ExitCode::SUCCESS;
    }

    println!("\nsolutions and mistakes of {stage}; `cargo learn` checks your own code");
    let (mut passed, mut failed) = (0, 0);
    for exercise in wanted {
        let mut problems = prove_solution(stage, exercise, named);
        for wrong in exercise.wrong {
            problems.extend(prove_wrong(wrong, named));
        }
        if exercise.wrong.len() < MIN_WRONG {
            problems.push(format!("fewer than {MIN_WRONG} wrong solutions"));
        }
        let refused = exercise.wrong.len();
        if problems.is_empty() {
            println!("exercise {} ... ok, {refused} mistakes fail", exercise.name);
            passed += 1 + refused;
        } else {
            println!("exercise {} ... FAILED", exercise.name);
            println!("    {}", problems.join("\n    "));
            failed += 1;
        }
    }
    let word = if failed == 0 { "ok" } else { "FAILED" };
    println!("\ntest result: {word}. {passed} passed; {failed} failed\n");
    ExitCode::from(u8::from(failed > 0))
}

fn prove_solution(stage: &str, exercise: &Exercise, named: bool) -> Vec<String> {
    let name = format!("{stage}-exercise-{}.png", exercise.name.replace('_', "-"));
    let folder = locked::folder().filter(|_| named);
    let shown = locked::in_book(&name);
    let pictures = Pictures {
        left: folder.map(|folder| folder.join(name)),
        shown: shown.exists().then_some(shown),
    };
    let Findings { missing, wrong } = Findings::of(exercise.solution, pictures);
    let said = missing.into_iter().chain(wrong);
    said.map(|said| format!("the solution: {said}")).collect()
}

/// The problem of a wrong solution, if the check accepts it or says nothing that helps.
fn prove_wrong(wrong: &Wrong, show: bool) -> Option<String> {
    let mistake = wrong.mistake;
    let messages = Findings::of(wrong.check, Pictures::default()).wrong;
    if show {
        println!("wrong: {mistake}\n    {}", messages.join("\n    "));
    }
    if messages.iter().any(|message| message.contains(wrong.says)) {
        None
    } else if messages.is_empty() {
        Some(format!("wrong, but accepted: {mistake}"))
    } else {
        let said = messages.join("\n        ");
        Some(format!(
            "wrong: {mistake}; no message says \"{}\", but\n        {said}",
            wrong.says
        ))
    }
}

/// The names in the arguments. The flags of Rust's test harness and their values are
/// not names.
fn names(mut arguments: impl Iterator<Item = String>) -> Vec<String> {
    let mut names = Vec::new();
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--test-threads" | "--skip" | "--format" | "--color" | "--logfile"
            | "--shuffle-seed" | "-Z" => {
                arguments.next();
            }
            flag if flag.starts_with('-') => {}
            _ => names.push(argument),
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_of_the_test_harness_and_their_values_are_not_names() {
        let names = |line: &str| names(line.split_whitespace().map(str::to_owned)).join(" ");
        assert_eq!(names("--nocapture --test-threads 1 -q cube"), "cube");
        assert_eq!(names("--exact sphere --skip cube --color=always"), "sphere");
    }
}
