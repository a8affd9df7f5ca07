//! Programs of exercises: they ask a student's code, or prove the exercises of a stage.
//!
//! The section "An exercise" of `CONTRIBUTING.md` says how to add one, a question, and a known mistake.

#[cfg(not(target_family = "wasm"))]
mod assertion;
#[cfg(not(target_family = "wasm"))]
mod corpus;
mod exercise;
mod folder;
#[cfg(target_family = "wasm")]
mod in_browser;
mod missing;
#[cfg(not(target_family = "wasm"))]
mod program;
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
pub use missing::missing;
#[cfg(not(target_family = "wasm"))]
pub(crate) use missing::{Missing, take_missing};
#[cfg(not(target_family = "wasm"))]
pub use prove::{Codes, Entry, prove};
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

/// The modules and the `main` of a stage's `tests/exercises/main.rs`, which has the names that
/// checks, examples and students' files use in a module `prelude`.
///
/// The program proves all exercises, and does not read the students' files: a file that does
/// not compile fails no test. `cargo learn` builds it with the configurations `learn` and `NAME`
/// instead, and such a program judges the student's file of that name.
#[macro_export]
macro_rules! exercises {
    ($stage:path; $(mod $name:ident;)+) => {
        $(
            #[cfg(any(not(learn), $name))]
            #[allow(clippy::semicolon_if_nothing_returned)]
            #[allow(clippy::manual_midpoint, clippy::type_complexity)]
            #[allow(clippy::trivially_copy_pass_by_ref)]
            mod $name;
        )+

        /// The students' files, which rust-analyzer reads, too.
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
                ($what:expr, $for_now:expr, $code:expr) => { $code };
            }
            $(pub mod $name;)+
        }

        #[cfg(not(learn))]
        #[path = "../../exercises/solutions"]
        #[allow(unused, clippy::all, clippy::pedantic, missing_docs)]
        mod starters {
            macro_rules! missing {
                ($what:expr, $for_now:expr, $code:expr) => { testing::missing($what, $for_now) };
            }
            $(pub mod $name;)+
        }

        #[allow(unused_imports)]
        fn main() -> std::process::ExitCode {
            use prelude::*;
            let folder = $crate::exercises::StageFolder::new(env!("CARGO_MANIFEST_DIR"), $stage);
            $(
                #[cfg(all(learn, $name))]
                let exit = {
                    // A file may have none.
                    fn examples() {}
                    let examples = { use yours::$name::*; examples };
                    let yours = $name::code!(crate::yours::$name);
                    let exercise = $name::exercise();
                    $crate::exercises::judge(&folder, stringify!($name), exercise, yours, examples)
                };
            )+
            #[cfg(not(learn))]
            let exit = $crate::exercises::prove(&folder, vec![$(
                $crate::exercises::Entry::new(stringify!($name), $crate::exercises::Codes {
                    exercise: $name::exercise,
                    // Bound first, as in a student's program: the code alone says its type.
                    solution: || { let yours = $name::code!(crate::solutions::$name); yours },
                    examples: solutions::$name::examples,
                    starter: || { let yours = $name::code!(crate::starters::$name); yours },
                }),
            )+]);
            exit
        }
    };
}
