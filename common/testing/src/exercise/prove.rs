//! `prove`: proves the checks of a stage by starters, solutions and usual mistakes.

use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial};

use super::check::{Check, Findings, Pictures};
use super::{Exercise, Wrong, locked};

/// Proves that starters are to do, and that checks accept all solutions and refuse all
/// wrong ones.
///
/// The arguments are those of every test. With a part of a name, the messages of the wrong
/// solutions are printed, and the pictures of the solutions are saved.
#[must_use]
pub fn prove(stage: &'static str, exercises: impl IntoIterator<Item = Exercise>) -> ExitCode {
    // Checks share the list of missing parts.
    let arguments = Arguments {
        test_threads: Some(1),
        ..Arguments::from_args()
    };
    let named = arguments.filter.is_some();
    let mut trials = Vec::new();
    for exercise in exercises {
        let name = exercise.name;
        trials.push(Trial::test(format!("{name}::starter"), move || {
            prove_starter(exercise.starter)
        }));
        trials.push(Trial::test(format!("{name}::solution"), move || {
            prove_solution(stage, name, exercise.solution, named)
        }));
        for wrong in exercise.wrong {
            let title = format!("{name}::wrong: {}", wrong.mistake);
            trials.push(Trial::test(title, move || prove_wrong(wrong, named)));
        }
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}

fn prove_starter(check: fn(&mut Check)) -> Result<(), Failed> {
    let missing = Findings::of(check, Pictures::default()).missing;
    let is_to_do = !missing.is_empty();
    is_to_do.then_some(()).ok_or("nothing is missing".into())
}

fn prove_solution(
    stage: &str,
    name: &str,
    check: fn(&mut Check),
    save: bool,
) -> Result<(), Failed> {
    let file = format!("{stage}-exercise-{}.png", name.replace('_', "-"));
    let shown = locked::in_book(&file);
    let pictures = Pictures {
        left: locked::folder()
            .filter(|_| save)
            .map(|folder| folder.join(file)),
        shown: shown.exists().then_some(shown),
    };
    let Findings { missing, wrong } = Findings::of(check, pictures);
    match [missing, wrong].concat().as_slice() {
        [] => Ok(()),
        problems => Err(problems.join("\n").into()),
    }
}

/// Fails if the check accepts a wrong solution or says nothing that helps.
fn prove_wrong(wrong: &Wrong, show: bool) -> Result<(), Failed> {
    let messages = Findings::of(wrong.check, Pictures::default()).wrong;
    if show {
        println!("    {}", messages.join("\n    "));
    }
    if messages.iter().any(|message| message.contains(wrong.says)) {
        return Ok(());
    }
    let said = messages.join("\n");
    Err(format!("no message says \"{}\", but\n{said}", wrong.says).into())
}
