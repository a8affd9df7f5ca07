//! Exercises: starters that students finish, checks that tell how far they
//! are, and solutions that prove the checks.
//!
//! # How to add an exercise
//!
//! 1. Write the solution, `exercises/solutions/NAME.rs`: what the student is to
//!    write stands between `// exercise` and `// instead`; the lines from there
//!    to `// end` are comments and become code in the starter. They call
//!    [`missing`](crate::missing).
//!
//!    ```ignore
//!    pub fn square(x: f64) -> f64 {
//!        // exercise
//!        x * x
//!        // instead
//!        // common::missing("the square of x", 0.0)
//!        // end
//!    }
//!    ```
//! 2. Copy it to `exercises/NAME.rs`, which the student edits.
//! 3. Write the check, `tests/exercises/NAME.rs`. It takes what the student
//!    writes as an argument, so that the same check judges starter and solution:
//!
//!    ```ignore
//!    pub fn check(check: &mut Check, square: impl Fn(f64) -> f64) {
//!        check.expect("the square of -3", 9.0, Bound::Equal, square(-3.0));
//!    }
//!    ```
//! 4. Name all three in `tests/exercises/main.rs`: a `mod` each for check, starter
//!    and solution, and a line in [`exercises!`](crate::exercises).
//! 5. Give it a section in the book's page, `aNN-exercises.md`, with a hint.
//! 6. Make the starter from the solution, and prove it both ways:
//!
//!    ```console
//!    $ cargo test -p STAGE --test exercises -- --write-starters NAME
//!    $ cargo test -p STAGE --test exercises -- --starters
//!    $ cargo test -p STAGE --test exercises -- --solutions
//!    ```
//!
//! Expected values come from closed forms, never from the solution.

mod page;
mod runner;
mod starter;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::extremes::{Bound, Case, Outcome};
use crate::{Error, Image, Settings, Size, Transfer, picture_file};

pub use runner::run;

/// The stage that sets the exercises; [`exercises!`](crate::exercises) fills it in.
pub struct Stage {
    /// The crate's name.
    pub name: &'static str,
    /// The crate's folder.
    pub folder: &'static str,
}

/// An exercise; [`exercises!`](crate::exercises) makes it.
pub struct Exercise {
    /// The name of its files, without `.rs`.
    pub name: &'static str,
    /// The heading of its section in the book.
    pub title: &'static str,
    /// How long it takes.
    pub minutes: u32,
    /// The check of what the student edits.
    pub starter: fn(&mut Check),
    /// The same check of the solution.
    pub solution: fn(&mut Check),
}

/// Writes the `main` of a stage's `tests/exercises/main.rs`, where the modules
/// `starters` and `solutions` hold the files. A line is name, title, minutes
/// and a check, which sees the public items of the exercise's file.
///
/// ```ignore
/// common::exercises! {
///     square, "The square", 10 => |check| square::check(check, square);
/// }
/// ```
#[macro_export]
macro_rules! exercises {
    ($($name:ident, $title:literal, $minutes:literal => $check:expr;)+) => {
        fn main() -> std::process::ExitCode {
            let stage = $crate::exercise::Stage {
                name: env!("CARGO_PKG_NAME"),
                folder: env!("CARGO_MANIFEST_DIR"),
            };
            let exercises = [$(
                $crate::exercise::Exercise {
                    name: stringify!($name),
                    title: $title,
                    minutes: $minutes,
                    starter: {
                        use starters::$name::*;
                        $check
                    },
                    solution: {
                        use solutions::$name::*;
                        $check
                    },
                }
            ),+];
            $crate::exercise::run(&stage, &exercises)
        }
    };
}

/// What the running check has found missing.
static MISSING: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// Stands in a starter for what the student is to write, and is `for_now`. The
/// check, which meets it, says once that `what` is missing.
pub fn missing<T>(what: &str, for_now: T) -> T {
    let mut missing = MISSING.lock().unwrap_or_else(PoisonError::into_inner);
    if !missing.iter().any(|known| known == what) {
        missing.push(what.to_owned());
    }
    for_now
}

/// Compares what the student's code computes with what is right.
#[derive(Default)]
pub struct Check {
    compared: Vec<Case>,
    /// Where the picture goes, if one is wanted.
    picture: Option<PathBuf>,
}

impl Check {
    /// Compares an outcome with the exact one: what is computed, its exact value,
    /// how far off is right, and what the student's code makes of it.
    pub fn expect(
        &mut self,
        what: impl Into<String>,
        exact: impl Into<Outcome>,
        bound: Bound,
        got: impl Into<Outcome>,
    ) {
        self.compared.push(Case::new("", what, exact, bound, got));
    }

    /// Leaves a small picture made with the student's code, if this exercise was
    /// asked for by name.
    pub fn picture(&mut self, paint: impl FnOnce(&Settings) -> Result<Image, Error>) {
        let Some(path) = self.picture.take() else {
            return;
        };
        match paint_to(&path, paint) {
            Ok(()) => println!("picture: {}", path.display()),
            Err(error) => println!("no picture: {error}"),
        }
    }
}

fn paint_to(
    path: &Path,
    paint: impl FnOnce(&Settings) -> Result<Image, Error>,
) -> Result<(), Error> {
    let settings = Settings {
        size: Size::new(320, 240)?,
        ..Settings::default()
    };
    let image = paint(&settings)?;
    let rgb = image.to_rgb8(Transfer::Linear);
    picture_file::save_png(path, image.size(), &rgb)
}

/// What a check finds.
struct Findings {
    /// What the code still lacks.
    missing: Vec<String>,
    /// What differs, and how far off it is.
    wrong: Vec<String>,
}

/// How many differences are told in full.
const TOLD: usize = 3;

impl Findings {
    /// Runs a check; a picture, if it makes one, goes to `picture`.
    fn of(run: fn(&mut Check), picture: Option<PathBuf>) -> Self {
        let take_missing =
            || std::mem::take(&mut *MISSING.lock().unwrap_or_else(PoisonError::into_inner));
        take_missing();
        let mut check = Check {
            picture,
            ..Check::default()
        };
        let panicked = catch_unwind(AssertUnwindSafe(|| run(&mut check))).is_err();

        let mut wrong = Vec::new();
        if panicked {
            wrong.push("it panics, with the message above".to_owned());
        }
        let compared = check.compared.len();
        let differ: Vec<_> = check.compared.iter().filter(|case| !case.holds()).collect();
        if !differ.is_empty() {
            wrong.push(format!("{} of {compared} comparisons differ", differ.len()));
        }
        let told = differ.iter().take(TOLD);
        wrong.extend(told.map(|case| format!("{}: {}", case.what, case.comparison())));
        Self {
            missing: take_missing(),
            wrong,
        }
    }
}
