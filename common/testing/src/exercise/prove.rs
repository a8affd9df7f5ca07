//! `prove`: proves the checks of a stage by starters, solutions and variants.

use std::panic;
use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial};

use super::findings::Findings;
use super::{Code, Exercise, Variant, picture};

/// Proves that starters are to do, that examples hold for the solutions, and that checks
/// accept all right variants and refuse all mistakes.
///
/// The arguments are those of every test. With a part of a name, the messages about
/// mistakes are printed, and the pictures of the solutions are saved.
#[must_use]
pub fn prove(stage: &'static str, exercises: impl IntoIterator<Item = Exercise>) -> ExitCode {
    // Checks share the list of missing parts.
    let arguments = Arguments {
        test_threads: Some(1),
        ..Arguments::from_args()
    };
    let shows = arguments.filter.is_some();
    if !shows {
        panic::set_hook(Box::new(|_| ()));
    }
    let mut trials = Vec::new();
    for exercise in exercises {
        let (name, variants) = (exercise.name, exercise.variants);
        let mistakes = variants.iter().filter(|variant| !variant.is_right);
        assert!(mistakes.count() >= 3, "{name} has at least three mistakes");
        let picture = format!("{stage}-exercise-{}.png", name.replace('_', "-"));
        trials.push(Trial::test(format!("{name}::starter"), move || {
            let is_to_do = !Findings::of(exercise.starter, false).missing.is_empty();
            is_to_do.then_some(()).ok_or("nothing is missing".into())
        }));
        trials.push(Trial::test(format!("{name}::solution"), move || {
            prove_solution(exercise.solution, &picture, shows)
        }));
        trials.extend(variants.iter().map(|variant| {
            let kind = if variant.is_right { "right" } else { "wrong" };
            let title = format!("{name}::{kind}: {}", variant.about);
            Trial::test(title, move || prove_variant(variant, shows))
        }));
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}

/// Fails if the check refuses the solution, or if its picture is not the book's.
fn prove_solution(code: Code, name: &str, save: bool) -> Result<(), Failed> {
    let found = Findings::of(code, true);
    let mut problems = [found.missing, found.wrong].concat();
    if let Some(image) = found.check.picture {
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

/// Fails if the check refuses a right variant, or accepts a mistake.
fn prove_variant(variant: &Variant, show: bool) -> Result<(), Failed> {
    let code = Code {
        examples: || (),
        check: variant.check,
    };
    let wrong = Findings::of(code, false).wrong;
    if show {
        println!("{}", wrong.join("\n"));
    }
    match (variant.is_right, wrong.is_empty()) {
        (true, false) => Err(wrong.join("\n").into()),
        (false, true) => Err("the check accepts it".into()),
        _ => Ok(()),
    }
}
