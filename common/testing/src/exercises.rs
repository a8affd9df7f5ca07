//! Programs of exercises: they ask a student's code.
//!
//! The section "An exercise" of `CONTRIBUTING.md` says how to add one, a question, and a known mistake.

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
mod student;

pub use self::exercise::{Exercise, Form, StudentPicture};
pub use common::ArgumentError;
pub use folder::StageFolder;
#[cfg(target_family = "wasm")]
pub use in_browser::run;
pub use judge::answers::{Answer, Input};
pub use judge::{assert_close, input};
pub use missing::missing;
#[cfg(not(target_family = "wasm"))]
pub(crate) use missing::{Missing, take_missing};
#[cfg(not(target_family = "wasm"))]
pub use student::run;

/// A value, or the argument of its constructor that is wrong.
pub type Made<T> = Result<T, ArgumentError>;

/// The student's code of a check: the names that a student's file defines, and an expression of
/// them and of the prelude, in the form that the questions of the exercise take, such as
/// `yours! { Sphere => new_shape(|(c, r)| Sphere::new(point(c), r)) }`; or a name alone. It is
/// compiled with the names of the student's file.
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
/// `cargo learn` and the grader build it with the configuration `NAME` of each exercise: such a program judges the
/// student's file whose name is its argument. A file that does not compile stops no other exercise.
#[macro_export]
macro_rules! exercises {
    ($stage:path; $(mod $name:ident;)+) => {
        // The checks: what is asked.
        $(
            #[cfg(any($name, clippy, rust_analyzer))]
            #[allow(clippy::semicolon_if_nothing_returned)]
            #[allow(clippy::manual_midpoint, clippy::type_complexity)]
            #[allow(clippy::trivially_copy_pass_by_ref)]
            mod $name;
        )+

        /// In a solution, the code that its starter lacks.
        macro_rules! missing {
            ($what:expr, $for_now:expr, $code:expr) => { $code };
        }

        // The files that are asked. `cargo course prove` has them in another folder, which holds none of a student.
        #[cfg_attr(not(any(clippy, proved)), path = "../../exercises")]
        #[cfg_attr(clippy, path = "../../exercises/solutions")]
        #[cfg_attr(proved, path = "../../../target/proved")]
        #[allow(unused, clippy::all, clippy::pedantic, missing_docs)]
        mod yours {
            $(#[cfg(any($name, clippy, rust_analyzer))] pub mod $name;)+
        }

        #[allow(unused_imports)]
        fn main() -> std::process::ExitCode {
            use prelude::*;
            // A file may have none.
            fn examples() {}
            let folder = $crate::exercises::StageFolder::new(env!("CARGO_MANIFEST_DIR"), $stage);
            $crate::exercises::run(&folder, vec![$(
                #[cfg(any($name, clippy))]
                $crate::exercises::Entry {
                    name: stringify!($name),
                    exercise: || {
                        // Bound first: the code alone says its type.
                        let yours = $name::code!(crate::yours::$name);
                        $name::exercise().with_code(yours)
                    },
                    examples: { use yours::$name::*; examples },
                },
            )+])
        }
    };
}
