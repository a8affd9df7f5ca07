//! Programs of exercises: they ask a student's code, or prove the exercises of a stage.
//!
//! # How to add an exercise
//!
//! An exercise is two files of the same name in a stage, which the build finds by themselves.
//!
//! 1. Where the student writes a part of the lesson, the starter, `exercises/starters/NAME.rs`,
//!    compiles, calls [`missing`] instead of the code that is left to the student, and ends with
//!    three to six [`examples!`](crate::examples); the solution is the lesson's type, or a function
//!    in the file of the check that calls it. Elsewhere write the solution,
//!    `exercises/solutions/NAME.rs`, with examples. The student's part stands in
//!    `missing!("what is missing", a value for now, {`, ends with a line `})`, and is cut out of
//!    the starter.
//! 2. The check, `tests/exercises/NAME.rs`, has a function `exercise()`, which returns an
//!    [`Exercise`]: its questions, its picture, which no other one shows, right solutions in another style, and mistakes of
//!    learners, at least three with the [`usual`](Exercise::usual) ones of its kind. A mistake is
//!    one row: the fact that it overlooks, and a function that makes code with this mistake of
//!    right code. [`yours!`](crate::yours) is the student's code in the form that the questions
//!    take.
//! 3. `INSTA_UPDATE=always cargo test -p STAGE --test exercises -- NAME` records the right answers
//!    and those of the mistakes in `exercises/answers/NAME.txt`; without the variable it proves the
//!    exercise, shows the messages that students read, and leaves the picture of the solution in
//!    `out/exercises/`.
//! 4. The task is a section of the page `book/src/aNN-exercises.md`. Without a section, the comment
//!    at the beginning of the first file is title, minutes and task, such as
//!    `//! A camera for a dome, 20 minutes`, an empty line, and paragraphs. In the comment of the
//!    check each paragraph after the first is a hint.
//! 5. Of the core path, `exercises/hints/NAME.rs` is the starter with the lines of the first hint in
//!    the right order, without examples. The proof asks it as it asks a right solution.

mod folder;
#[cfg(target_family = "wasm")]
mod in_browser;
mod kind;
mod missing;
#[cfg(not(target_family = "wasm"))]
mod program;
#[cfg(not(target_family = "wasm"))]
mod prove;
mod random;
#[cfg(not(target_family = "wasm"))]
mod say;
#[cfg(not(target_family = "wasm"))]
mod student;

pub use common::ArgumentError;
pub use exercise::{Answer, Input, assert_close};
pub use folder::StageFolder;
#[cfg(target_family = "wasm")]
pub use in_browser::judge;
pub use kind::{
    CodeQuestion, Exercise, Group, Picture, Questions, Render, Search, Variant, drawing, searched,
};
pub use missing::missing;
#[cfg(not(target_family = "wasm"))]
pub(crate) use missing::{Missing, found_missing};
#[cfg(not(target_family = "wasm"))]
pub use prove::{Entry, Hint, entry, hint, prove};
pub use random::{Random, random};
#[cfg(not(target_family = "wasm"))]
pub use student::judge;

/// A value, or the argument of its constructor that is wrong.
pub type Made<T> = Result<T, ArgumentError>;

/// The student's code of a check: the names that a student's file defines, and an expression of
/// them and of the prelude, in the form that the questions of the exercise take, such as
/// `yours! { Sphere => new_shape(|(c, r)| Sphere::new(point(c), r)) }`; or a name alone. It is
/// compiled with the names of the student's file, of the starter, and of the solution.
#[macro_export]
macro_rules! yours {
    ($name:ident) => { $crate::yours! { $name => $name } };
    ($($name:ident),+ => $code:expr) => {
        /// The code with the names of a module, or with those in scope.
        macro_rules! code {
            () => { $code };
            ($module:path) => {{
                use $module as module;
                use module::{$($name),+};
                $code
            }};
        }
        pub(crate) use code;
    };
}

/// The examples at the end of a starter: assertions, which run before the questions.
///
/// The tests prove them with the solution instead of the starter.
#[macro_export]
macro_rules! examples {
    ($($body:tt)*) => {
        pub fn examples() { $($body)* }

        macro_rules! body { () => { $($body)* } }
        pub(crate) use body;
    };
}

/// The modules and the `main` of a stage's `tests/exercises/main.rs`, which has the names that
/// checks, examples and students' files use in a module `prelude`. The stage's build script writes
/// the call, with the crate `exercise-list`: so a new exercise is two files and no more.
///
/// The program proves all exercises, and does not read the students' files: a file that does
/// not compile fails no test. `cargo learn` builds it with the configurations `learn` and `NAME`
/// instead, and such a program judges the student's file of that name.
#[macro_export]
macro_rules! exercises {
    (
        stage $stage:path; solved { $($solved:ident)* } open { $($open:ident)* }
        hints { $($hint:ident)* }
        $($folder:ident { $($name:ident)* })+
    ) => {
        /// The names of all solutions, for the prelude.
        #[allow(unused_imports, ambiguous_glob_reexports)]
        mod solved {
            $(#[cfg(not(learn))] pub use super::solutions::$solved::*;)*
        }

        #[cfg(not(learn))]
        #[path = "../../exercises/solutions"]
        #[allow(unused)]
        mod solutions {
            macro_rules! missing {
                ($what:expr, $for_now:expr, $code:expr) => { $code };
            }
            $(pub mod $solved;)*
        }

        $($(
            #[cfg(any(not(learn), $name))]
            #[allow(clippy::semicolon_if_nothing_returned)]
            #[allow(clippy::manual_midpoint, clippy::type_complexity)]
            mod $name;
        )*)+
        $(#[cfg($open)] mod $open;)*

        /// The students' files, which rust-analyzer reads, too.
        #[cfg(any(learn, rust_analyzer))]
        #[path = "../../exercises"]
        #[allow(clippy::all, clippy::pedantic, missing_docs)]
        mod yours {
            $($(#[cfg(any($name, rust_analyzer))] pub mod $name;)*)+
            $(#[cfg(any($open, rust_analyzer))] pub mod $open;)*
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

        /// Starters with the lines of their first hint in the right order.
        #[cfg(not(learn))]
        #[path = "../../exercises/hints"]
        #[allow(unused, clippy::all, clippy::pedantic, missing_docs)]
        mod hints {
            $(pub mod $hint;)*
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
            let folder = $crate::exercises::StageFolder::new(env!("CARGO_MANIFEST_DIR"), $stage);
            $($(
                #[cfg($name)]
                let exit = $crate::exercises! { @judge folder $name };
            )*)+
            $(
                #[cfg($open)]
                let exit = $crate::exercises! { @judge folder $open };
            )*
            #[cfg(not(learn))]
            let exit = $crate::exercises::prove(&folder, vec![$($({
                use prelude::*;
                $crate::exercises::entry(
                    stringify!($name),
                    $name::exercise,
                    || $name::code!(crate::starters::$folder::$name),
                    starters::$folder::$name::examples,
                    || { use $name::*; $name::code!() },
                    proved::$name,
                )
            },)*)+], vec![$({
                use prelude::*;
                $crate::exercises::hint(
                    stringify!($hint),
                    $hint::exercise,
                    || $hint::code!(crate::hints::$hint),
                )
            },)*]);
            exit
        }
    };
    (@judge $folder:ident $name:ident) => {{
        use prelude::*;
        // A file may have none.
        fn examples() {}
        let examples = { use yours::$name::*; examples };
        let (name, exercise) = (stringify!($name), $name::exercise());
        let yours = $name::code!(crate::yours::$name);
        $crate::exercises::judge(&$folder, name, exercise, yours, examples)
    }};
}
