//! Programs of exercises: they ask a student's code, or prove the exercises of a stage.
//!
//! The section "An exercise" of `CONTRIBUTING.md` says how to add one, a question, and a known mistake.

#[cfg(not(target_family = "wasm"))]
mod assertion;
#[cfg(not(target_family = "wasm"))]
mod corpus;
mod exercise;
#[cfg(not(target_family = "wasm"))]
mod findings;
mod folder;
#[cfg(not(target_family = "wasm"))]
mod hang;
#[cfg(target_family = "wasm")]
mod in_browser;
mod missing;
#[cfg(not(target_family = "wasm"))]
mod prove;
#[cfg(not(target_family = "wasm"))]
mod student;

pub use self::exercise::{Exercise, Form, Picture};
pub use ::exercise::{Answer, Input, assert_close, input};
pub use common::ArgumentError;
pub use folder::StageFolder;
#[cfg(target_family = "wasm")]
pub use in_browser::judge;
#[cfg(not(target_family = "wasm"))]
pub(crate) use missing::{Missing, as_starter, take_missing};
pub use missing::{is_starter, missing};
#[cfg(not(target_family = "wasm"))]
pub use prove::prove;
#[cfg(not(target_family = "wasm"))]
pub use student::judge;

/// A value, or the argument of its constructor that is wrong.
pub type Made<T> = Result<T, ArgumentError>;

/// The student's code of a check: the names that a student's file defines, and an expression of
/// them and of the prelude, in the form that the questions of the exercise take, such as
/// `yours! { Sphere => new_shape(|(c, r)| Sphere::new(point(c), r)) }`; or a name alone. It is
/// compiled with the names of the student's file, or of the solution.
#[macro_export]
macro_rules! yours {
    ($name:ident) => { $crate::yours! { $name => $name } };
    ($($name:ident),+ => $code:expr) => {
        /// The code with the names of a module.
        macro_rules! code {
            ($module:path) => {{
                use $module as module;
                use module::{$($name),+};
                $code
            }};
        }
        pub(crate) use code;
    };
}

/// The examples at the end of a student's file: assertions, which run before the questions.
#[macro_export]
macro_rules! examples {
    ($($body:tt)*) => {
        pub fn examples() { $($body)* }
    };
}

/// An exercise with the code of a file.
pub struct Entry {
    /// Its name, which is that of the file.
    pub name: &'static str,
    /// The exercise with the code in it.
    pub exercise: fn() -> Exercise<()>,
    /// The examples at the end of the file.
    pub examples: fn(),
}

/// The modules and the `main` of a stage's `tests/exercises/main.rs`, which has the names that
/// checks, examples and students' files use in a module `prelude`.
///
/// The program proves all exercises, and does not read the students' files: a file that does
/// not compile fails no test. `cargo learn` and the grader build it with the configurations `learn` and, of each
/// exercise, `NAME` instead, and such a program judges the student's file whose name is its argument.
#[macro_export]
macro_rules! exercises {
    ($stage:path; $(mod $name:ident;)+) => {
        // The checks: what is asked.
        $(
            #[cfg(any(not(learn), $name))]
            #[allow(clippy::semicolon_if_nothing_returned)]
            #[allow(clippy::manual_midpoint, clippy::type_complexity)]
            #[allow(clippy::trivially_copy_pass_by_ref)]
            mod $name;
        )+

        // The files that are asked: the students', which rust-analyzer reads, too, or the solutions.
        #[cfg(any(learn, rust_analyzer))]
        #[path = "../../exercises"]
        #[allow(clippy::all, clippy::pedantic, missing_docs)]
        mod yours {
            $(#[cfg(any($name, rust_analyzer))] pub mod $name;)+
        }
        #[cfg(not(learn))]
        #[path = "../../exercises/solutions"]
        #[allow(unused, clippy::all, clippy::pedantic, missing_docs)]
        mod solutions {
            macro_rules! missing {
                ($what:expr, $for_now:expr, $code:expr) => {
                    if testing::is_starter() { testing::missing($what, $for_now) } else { $code }
                };
            }
            $(pub mod $name;)+
        }

        // Students' files are judged, and solutions are proved.
        #[cfg(learn)]
        use {$crate::exercises::judge as run, yours as files};
        #[cfg(not(learn))]
        use {$crate::exercises::prove as run, solutions as files};

        #[allow(unused_imports)]
        fn main() -> std::process::ExitCode {
            use prelude::*;
            // A file may have none.
            fn examples() {}
            let folder = $crate::exercises::StageFolder::new(env!("CARGO_MANIFEST_DIR"), $stage);
            run(&folder, vec![$(
                #[cfg(any(not(learn), $name))]
                $crate::exercises::Entry {
                    name: stringify!($name),
                    exercise: || {
                        // Bound first: the code alone says its type.
                        let yours = $name::code!(crate::files::$name);
                        $name::exercise().with_code(yours)
                    },
                    examples: { use files::$name::*; examples },
                },
            )+])
        }
    };
}
