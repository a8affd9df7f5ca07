//! Exercises: starters that students complete, checks that judge their code, solutions
//! and usual mistakes that prove the checks.
//!
//! # How to add an exercise
//!
//! `triangle_area` of `a02-math` is an example of each file.
//!
//! 1. Write the starter, `exercises/starters/NAME.rs`: it compiles, and calls
//!    [`missing`] in the place of the code that is left to the student. `cargo learn`
//!    copies it to `exercises/NAME.rs`, which no commit of the workbook contains.
//! 2. Write the solution, `exercises/solutions/NAME.rs`. On the core path, where the
//!    student writes a part of the lesson, it is a `pub use` of the lesson's type, or a
//!    function that calls the lesson.
//! 3. Write the check, `tests/exercises/NAME.rs`. It takes the student's code as an
//!    argument. Expected values come from closed forms, never from the solution.
//! 4. Write the usual mistakes, `tests/exercises/wrong/NAME.rs`: at least three
//!    solutions, as short as can be, that the check must refuse with a message
//!    that helps.
//! 5. Add a line to [`exercises!`](crate::exercises) in `tests/exercises/main.rs`.
//! 6. Give it a section in the book's page, `book/src/aNN-exercises.md`: task, minutes
//!    and hints, which `cargo learn` shows, too.
//! 7. Prove it with `cargo test -p STAGE --test exercises -- NAME`, which shows the
//!    messages that students read, and leaves the picture of the solution in
//!    `out/exercises/`; the book has it as `pictures/STAGE-exercise-NAME.png`.

mod check;
mod findings;
mod judge;
mod picture;
mod prove;
mod random;

pub use check::Check;
pub use findings::missing;
pub use judge::judge;
pub use prove::prove;
pub use random::Random;

/// An exercise with the proofs of its check; [`exercises!`](crate::exercises) makes it.
pub struct Exercise {
    /// The name of its files, without `.rs`.
    pub name: &'static str,
    /// The check of the starter, where parts of the code are missing.
    pub starter: fn(&mut Check),
    /// The check of the solution.
    pub solution: fn(&mut Check),
    /// Usual wrong solutions, at least three.
    pub wrong: &'static [Wrong],
}

/// A usual wrong solution, which the check must refuse.
pub struct Wrong {
    /// The mistake in a few words.
    pub mistake: &'static str,
    /// The part of a message that helps a student to find the mistake.
    pub says: &'static str,
    /// The check of the wrong solution.
    pub check: fn(&mut Check),
}

/// Writes the modules and the `main` of a stage's `tests/exercises/main.rs`. A line is
/// the name of an exercise and a check, which sees the public items of its file.
///
/// ```ignore
/// testing::exercises! {
///     square => |check| square::check(check, square);
/// }
/// ```
///
/// The test proves all checks, and does not read the students' files: a file that does
/// not compile fails no test. `cargo learn` builds the test program with the
/// configurations `learn` and `NAME` instead, and such a program judges the student's
/// file of that name.
#[macro_export]
macro_rules! exercises {
    ($($name:ident => $check:expr;)+) => {
        $(#[cfg(any(not(learn), $name))] mod $name;)+

        /// The students' files, which rust-analyzer reads, too.
        #[cfg(any(learn, rust_analyzer))]
        #[path = "../../exercises"]
        #[allow(clippy::all, clippy::pedantic, missing_docs)]
        mod yours {
            $(#[cfg(any($name, rust_analyzer))] pub mod $name;)+
        }

        #[cfg(not(learn))]
        #[path = "../../exercises/starters"]
        #[allow(unused, clippy::all, clippy::pedantic, missing_docs)]
        mod starters { $(pub mod $name;)+ }

        #[cfg(not(learn))]
        #[path = "../../exercises/solutions"]
        mod solutions { $(pub mod $name;)+ }

        #[cfg(not(learn))]
        mod wrong { $(pub mod $name;)+ }

        fn main() -> std::process::ExitCode {
            let stage = env!("CARGO_PKG_NAME");
            $(
                #[cfg($name)]
                return $crate::exercise::judge(stage, stringify!($name), {
                    use yours::$name::*;
                    $check
                });
            )+
            #[cfg(not(learn))]
            $crate::exercise::prove(stage, [$(
                $crate::exercise::Exercise {
                    name: stringify!($name),
                    starter: { use starters::$name::*; $check },
                    solution: { use solutions::$name::*; $check },
                    wrong: wrong::$name::WRONG,
                }
            ),+])
        }
    };
}
