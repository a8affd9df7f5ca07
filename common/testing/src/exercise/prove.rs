//! `prove`: proves the checks of a stage by starters, solutions and variants.

use std::panic;
use std::process::ExitCode;

use libtest_mimic::{Arguments, Failed, Trial};

use super::findings::Findings;
use super::{Check, Code, Exercise, Variant, picture};

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
    panic::set_hook(Box::new(move |panic| {
        if shows {
            println!("{panic}");
        }
    }));
    let mut trials = Vec::new();
    for exercise in exercises {
        let (name, variants) = (exercise.name, exercise.variants);
        let picture = format!("{stage}-exercise-{}.png", name.replace('_', "-"));
        trials.push(Trial::test(format!("{name}::starter"), move || {
            let found = Findings::of(exercise.starter, Check::default());
            let is_to_do = !found.missing.is_empty();
            is_to_do.then_some(()).ok_or("nothing is missing".into())
        }));
        trials.push(Trial::test(format!("{name}::solution"), move || {
            let found = Findings::of(exercise.solution, Check::watched());
            let mistakes = variants.iter().filter(|variant| !variant.is_right).count();
            let usual = found.check.usual.clone();
            prove_solution(found, &picture, shows)?;
            if mistakes + usual.len() < 3 {
                return Err("there are less than three mistakes".into());
            }
            let mut usual = usual.into_iter().enumerate();
            usual.try_for_each(|(index, about)| {
                let found = Findings::of(exercise.solution, Check::brief(Some(index)));
                prove_wrong(about, &found, shows)
            })
        }));
        trials.extend(variants.iter().map(|variant| {
            let kind = if variant.is_right { "right" } else { "wrong" };
            let title = format!("{name}::{kind}: {}", variant.about);
            Trial::test(title, move || prove_variant(variant, shows))
        }));
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}

/// Fails if the check has refused the solution, or if its picture is not the book's.
fn prove_solution(found: Findings, name: &str, save: bool) -> Result<(), Failed> {
    let mut problems = [found.missing, found.wrong].concat();
    if let Some(image) = found.check.picture {
        if save {
            picture::save(&image, name);
        }
        let shown = picture::in_book(name);
        if shown.is_file() {
            problems.extend(picture::compare(&shown, &image, true).err());
        }
    }
    match problems.as_slice() {
        [] => Ok(()),
        problems => Err(problems.join("\n").into()),
    }
}

/// Fails if the check has accepted a mistake.
fn prove_wrong(about: &str, found: &Findings, show: bool) -> Result<(), Failed> {
    if show {
        println!("{about}\n  {}", found.wrong.join("\n  "));
    }
    match found.wrong.as_slice() {
        [] => Err(format!("the check accepts: {about}").into()),
        _ => Ok(()),
    }
}

fn prove_variant(variant: &Variant, show: bool) -> Result<(), Failed> {
    let (examples, check): (fn(), _) = (|| (), variant.check);
    let found = Findings::of(Code { examples, check }, Check::brief(None));
    if variant.is_right {
        prove_solution(found, "", false)
    } else {
        prove_wrong(variant.about, &found, show)
    }
}
