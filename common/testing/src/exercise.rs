//! Exercises: starters that students complete, checks that show their progress, and
//! solutions that prove the checks.
//!
//! # How to add an exercise
//!
//! 1. Write the solution, `exercises/solutions/NAME.rs`: what the student is to
//!    write stands between `// exercise` and `// instead`; the lines from there
//!    to `// end` are comments and become code in the starter. They call
//!    [`missing`].
//!
//!    ```ignore
//!    pub fn square(x: f64) -> f64 {
//!        // exercise
//!        x * x
//!        // instead
//!        // testing::missing("the square of x", 0.0)
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
//! 5. Give it a section in the book's page, `aNN-exercises.md`, with a hint. If
//!    its check makes a picture, `-- --solutions NAME` leaves that of the solution
//!    in `out/exercises/`; the book shows it as `pictures/STAGE-exercise-NAME.png`.
//! 6. Make the starter from the solution, and prove it both ways:
//!
//!    ```console
//!    $ cargo test -p STAGE --test exercises -- --write-starters NAME
//!    $ cargo test -p STAGE --test exercises -- --starters
//!    $ cargo test -p STAGE --test exercises -- --solutions
//!    ```
//!
//! Expected values come from closed forms, never from the solution.

mod check;
mod page;
mod runner;
mod starter;
mod task;

pub use check::{Check, missing};
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
/// testing::exercises! {
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
