//! `prove`: proves the checks of a stage by starters, solutions and variants.

use std::panic;
use std::process::ExitCode;
use std::sync::RwLock;

use libtest_mimic::{Arguments, Failed, Trial};

use super::findings::Findings;
use super::known::recognised;
use super::{Check, Code, Exercise, Mistakes, Variant, picture, replay};

/// Starters write into one list of missing parts, and so run alone.
static WITH_STARTER: RwLock<()> = RwLock::new(());

/// Proves that starters are to do, that examples hold for the solutions, and that checks
/// accept all right variants and refuse all mistakes.
///
/// The arguments are those of every test. With a part of a name, the messages about
/// mistakes are printed, and the pictures of the solutions are saved.
#[must_use]
pub fn prove(stage: &'static str, exercises: impl IntoIterator<Item = Exercise>) -> ExitCode {
    let exercises: Vec<_> = exercises.into_iter().collect();
    if let Some(exit) = replay::replay(&exercises) {
        return exit;
    }
    let arguments = Arguments::from_args();
    let shows = arguments.filter.is_some();
    panic::set_hook(Box::new(move |panic| {
        if shows {
            println!("{panic}");
        }
    }));
    // Starters come first, so that they do not wait for others to end.
    let (mut starters, mut trials) = (Vec::new(), Vec::new());
    for exercise in exercises {
        let (name, variants) = (exercise.name, exercise.variants);
        let known = (exercise.solution.check, variants);
        starters.push(Trial::test(format!("{name}::starter"), move || {
            let _alone = WITH_STARTER.write();
            let found = Findings::of(exercise.starter, Check::default());
            let is_to_do = !found.missing.is_empty();
            is_to_do.then_some(()).ok_or("nothing is missing".into())
        }));
        // The solution is not here.
        if replay::recorded(stage, name).is_file() {
            continue;
        }
        let picture = format!("{stage}-exercise-{}.png", name.replace('_', "-"));
        trials.push(Trial::test(format!("{name}::solution"), move || {
            let _together = WITH_STARTER.read();
            let found = Findings::of(exercise.solution, Check::new(true, None));
            accept(&found, &picture, shows)?;
            let usual = found.check.usual;
            let mistakes = variants.iter().filter(|Variant(is_right, ..)| !is_right);
            // A handout has no variants.
            if !variants.is_empty() && mistakes.count() + usual.len() < 3 {
                return Err("there are less than three mistakes".into());
            }
            let mut usual = usual.into_iter().enumerate();
            usual.try_for_each(|(index, about)| {
                let check = Check::new(true, Some(index));
                refuse(about, &Findings::of(exercise.solution, check), known, shows)
            })
        }));
        trials.extend(variants.iter().map(|Variant(is_right, about, check)| {
            let kind = if *is_right { "right" } else { "wrong" };
            let (examples, check): (fn(), _) = (|| (), *check);
            Trial::test(format!("{name}::{kind}: {about}"), move || {
                let _together = WITH_STARTER.read();
                let found = Findings::of(Code { examples, check }, Check::new(!is_right, None));
                if *is_right {
                    accept(&found, "", false)
                } else {
                    refuse(about, &found, known, shows)
                }
            })
        }));
    }
    libtest_mimic::run(
        &arguments,
        [starters, trials].into_iter().flatten().collect(),
    )
    .exit_code()
}

/// Fails if the check has refused right code, or if its picture is not the book's.
fn accept(found: &Findings, name: &str, save: bool) -> Result<(), Failed> {
    let mut problems = [&found.missing[..], &found.wrong].concat();
    if let Some(image) = &found.check.picture {
        if save {
            picture::save(image, name);
        }
        let shown = picture::in_book(name);
        if shown.is_file() {
            problems.extend(picture::compare(&shown, image, true).err());
        }
    }
    let is_right = problems.is_empty();
    is_right.then_some(()).ok_or(problems.join("\n").into())
}

/// Fails if the check has accepted a mistake, or if it is not recognised.
fn refuse(about: &str, found: &Findings, known: Mistakes, show: bool) -> Result<(), Failed> {
    let known = recognised(&found.check, known).unwrap_or_default();
    if show {
        println!("{about}\n  {}\n  {known}", found.wrong.join("\n  "));
    }
    let is_known = known.starts_with("this is") && known.ends_with(about);
    let accepted = || format!("the check accepts it, or takes it for another: {known}").into();
    is_known.then_some(()).ok_or_else(accepted)
}
