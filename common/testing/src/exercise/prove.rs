//! `prove`: proves the checks of a stage by starters, solutions and usual mistakes.

use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial};

use super::findings::Findings;
use super::{Check, Exercise, Wrong, picture};

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
    let shows = arguments.filter.is_some();
    let mut trials = Vec::new();
    for exercise in exercises {
        let (name, wrong) = (exercise.name, exercise.wrong);
        assert!(wrong.len() >= 3, "{name} has at least three usual mistakes");
        let picture = format!("{stage}-exercise-{}.png", name.replace('_', "-"));
        trials.push(Trial::test(format!("{name}::starter"), move || {
            prove_starter(exercise.starter)
        }));
        trials.push(Trial::test(format!("{name}::solution"), move || {
            prove_solution(exercise.solution, &picture, shows)
        }));
        trials.extend(wrong.iter().map(|wrong| {
            let title = format!("{name}::wrong: {}", wrong.mistake);
            Trial::test(title, move || prove_wrong(wrong, shows))
        }));
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}

fn prove_starter(check: fn(&mut Check)) -> Result<(), Failed> {
    let is_to_do = !Findings::of(check, false).missing.is_empty();
    is_to_do.then_some(()).ok_or("nothing is missing".into())
}

/// Fails if the check refuses the solution, or if its picture is not the book's.
fn prove_solution(check: fn(&mut Check), name: &str, save: bool) -> Result<(), Failed> {
    let found = Findings::of(check, true);
    let mut problems = [found.missing, found.wrong].concat();
    if let Some(image) = found.picture {
        if save {
            picture::save(&image, name);
        }
        let shown = picture::in_book(name);
        if shown.exists() {
            problems.extend(picture::compare(&shown, &image, true).err());
        }
    }
    match problems.as_slice() {
        [] => Ok(()),
        problems => Err(problems.join("\n").into()),
    }
}

/// Fails if the check accepts a wrong solution or says nothing that helps.
fn prove_wrong(wrong: &Wrong, show: bool) -> Result<(), Failed> {
    let messages = Findings::of(wrong.check, false).wrong.join("\n    ");
    if show {
        println!("    {messages}");
    }
    let says = wrong.says;
    if messages.contains(says) {
        return Ok(());
    }
    Err(format!("no message says \"{says}\", but\n    {messages}").into())
}
