//! Exercises: starters that students complete, checks that compare their code with the
//! lesson, solutions, and variants that prove the checks.
//!
//! # How to add an exercise
//!
//! An exercise is two files of the same name in a stage, which the build finds by themselves.
//!
//! 1. Where the student writes a part of the lesson, the starter,
//!    `exercises/starters/NAME.rs`, compiles, calls [`missing`] in the place of the code that
//!    is left to the student, and ends with three to six [`examples!`](crate::examples); the
//!    solution is the lesson's type, or a function in the file of the check that calls it.
//!    Elsewhere write the solution, `exercises/solutions/NAME.rs`, with examples. The
//!    student's part stands in `missing!("what is missing", a value for now, {`, ends with a
//!    line `})`, and is cut out of the starter.
//! 2. The check, `tests/exercises/NAME.rs`, compares the student's code with the solution by
//!    [`Check::compare`]. Its [`variants!`](crate::variants) begin with the student's code; the
//!    others are right solutions in another style, and mistakes of learners: at least three with
//!    those of its kind ([`Check::usual`]). What only they use stands after them: a handout
//!    without solutions ends before.
//! 3. The task is a section of the page `book/src/aNN-exercises.md`. Without a section, the comment
//!    at the beginning of the first file is title, minutes and task, as
//!    `//! A camera for a dome, 20 minutes`, an empty line, and paragraphs. In the comment of the
//!    check each paragraph after the first is a hint.
//! 4. `cargo test -p STAGE --test exercises -- NAME` proves it, shows the messages that
//!    students read, and leaves the picture of the solution in `out/exercises/`.

use common::ArgumentError;

mod answer;
mod check;
mod findings;
mod input;
#[cfg_attr(target_family = "wasm", path = "../../../book/live/src/yours.rs")]
mod judge;
#[cfg_attr(target_family = "wasm", allow(dead_code))]
mod known;
#[cfg(not(target_family = "wasm"))]
mod picture;
#[cfg(not(target_family = "wasm"))]
mod prove;
mod random;
#[cfg(not(target_family = "wasm"))]
mod replay;
mod tape;

pub use answer::Answer;
pub use check::Check;
#[cfg(not(target_family = "wasm"))]
pub use common::difference::worst_pixel;
pub use findings::assert_close;
pub use input::Input;
pub use judge::judge;
#[cfg(not(target_family = "wasm"))]
pub use prove::prove;
pub use random::{Random, random};

/// A value, or the argument of its constructor that is wrong.
pub type Made<T> = Result<T, ArgumentError>;

/// The examples of a file and the check of its code.
#[derive(Clone, Copy)]
pub struct Code {
    /// Panics at the first example that fails.
    pub examples: fn(),
    /// Compares the code with the lesson.
    pub check: fn(&mut Check),
}

/// An exercise with the proofs of its check; [`exercises!`](crate::exercises) makes it.
pub struct Exercise {
    /// The name of its files, without `.rs`.
    pub name: &'static str,
    /// The starter, where parts of the code are missing.
    pub starter: Code,
    /// The solution.
    pub solution: Code,
    /// Other right solutions, and mistakes.
    pub variants: &'static [Variant],
}

/// Another right solution, or a usual mistake: whether the check must accept it, what it is
/// about, and the check of its code.
pub struct Variant(bool, &'static str, fn(&mut Check));

/// The check of the solution, and the variants of an exercise.
pub type Mistakes = (fn(&mut Check), &'static [Variant]);

/// A right solution in another style.
#[must_use]
pub const fn right(about: &'static str, check: fn(&mut Check)) -> Variant {
    Variant(true, about, check)
}

/// A usual mistake, with the fact that it overlooks, after which learners read "that".
#[must_use]
pub const fn wrong(about: &'static str, check: fn(&mut Check)) -> Variant {
    Variant(false, about, check)
}

/// Names the codes of a check: `variants! { variant: yours => code; right "in another style" =>
/// code; ... }`. The function `check` is called with those of the student's file, or of the
/// solution, and the function `variant` with those of each further row.
#[macro_export]
macro_rules! variants {
    ($variant:ident: yours => $($yours:expr),+; $($kind:ident $about:literal => $($code:expr),+;)*) => {
        pub const VARIANTS: &[$crate::exercise::Variant] =
            &[$($crate::exercise::$kind($about, |c| $variant(c, $($code),+))),*];

        macro_rules! yours { () => { |c| check(c, $($yours),+) } }
        pub(crate) use yours;
    };
}

/// The examples at the end of a starter: assertions, which run before the check.
///
/// The tests prove them with the solution in the place of the starter.
#[macro_export]
macro_rules! examples {
    ($($body:tt)*) => {
        pub fn examples() { $($body)* }

        macro_rules! body { () => { $($body)* } }
        pub(crate) use body;
    };
}

/// Writes the modules and the `main` of a stage's `tests/exercises/main.rs`, after the names
/// that checks and examples use by `crate::prelude`; the solutions are among them. The exercises
/// are the files in `exercises/starters`, whose solution is the lesson or in the check, and those
/// in `exercises/solutions`, whose starter is the solution without its code.
///
/// The test proves all checks, and does not read the students' files: a file that does
/// not compile fails no test. `cargo learn` builds the test program with the
/// configurations `learn` and `NAME` instead, and such a program judges the student's
/// file of that name; built for a page of the book, it renders the scenes of several names.
#[macro_export]
macro_rules! exercises {
    ($stage:ident uses $names:tt) => { $crate::listed! { $stage $names } };
    ($names:tt starters $starters:tt solutions { $($name:ident)* }) => {
        /// All names that checks and examples use.
        #[allow(unused_imports, ambiguous_glob_reexports)]
        mod prelude {
            pub use $names;
            pub use $crate::{assert_close, exercise::*, variants};
            $(#[cfg(any(not(learn), $name))] pub use super::solutions::$name::*;)*
        }

        /// In a handout they are starters.
        #[path = "../../exercises/solutions"]
        #[allow(unused)]
        mod solutions {
            macro_rules! missing {
                ($what:expr, $for_now:expr, $code:expr) => { $code };
            }
            $(#[cfg(any(not(learn), $name))] pub mod $name;)*
        }

        $crate::exercises! { starters $starters solutions { $($name)* } }
    };
    ($($folder:ident { $($name:ident)* })+) => {
        $($(
            #[cfg(any(not(learn), $name))]
            #[allow(clippy::semicolon_if_nothing_returned)]
            #[allow(clippy::manual_midpoint, clippy::type_complexity)]
            mod $name;
        )*)+

        /// The students' files, which rust-analyzer reads, too.
        #[cfg(any(learn, rust_analyzer))]
        #[path = "../../exercises"]
        #[allow(clippy::all, clippy::pedantic, missing_docs)]
        mod yours {
            $($(#[cfg(any($name, rust_analyzer))] pub mod $name;)*)+
        }

        #[cfg(not(learn))]
        #[path = "../../exercises"]
        #[allow(unused, clippy::all, clippy::pedantic, missing_docs)]
        mod starters {
            macro_rules! missing {
                ($what:expr, $for_now:expr, $code:expr) => { testing::missing($what, $for_now) };
            }
            $(pub mod $folder { $(pub mod $name;)* })+
        }

        /// The examples of starters, with the code of the solutions.
        #[cfg(not(learn))]
        #[allow(unused_imports, clippy::all, clippy::pedantic)]
        mod proved {
            $($(pub fn $name() {
                use super::{prelude::*, $name::*};
                super::starters::$folder::$name::body!();
            })*)+
        }

        #[allow(unused_imports)]
        fn main() -> std::process::ExitCode {
            use $crate::exercise::{Code, Exercise, judge};
            let stage = env!("CARGO_PKG_NAME");
            $($(
                #[cfg($name)]
                let judged = judge(stage, stringify!($name), {
                    use {yours::$name::*, $name::check};
                    Code { examples, check: $name::yours!() }
                }, {
                    use {prelude::*, $name::*};
                    ($name::yours!(), $name::VARIANTS)
                });
            )*)+
            #[cfg(learn)]
            return judged;
            #[cfg(not(learn))]
            $crate::exercise::prove(stage, [$($(Exercise {
                name: stringify!($name),
                starter: {
                    use {starters::$folder::$name::*, $name::check};
                    Code { examples, check: $name::yours!() }
                },
                solution: {
                    use {prelude::*, $name::*};
                    Code { examples: proved::$name, check: $name::yours!() }
                },
                variants: $name::VARIANTS,
            },)*)+])
        }
    };
}
