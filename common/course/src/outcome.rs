//! `Outcome`: what became of an exercise or an open sheet in a submission.

use std::path::PathBuf;

use judge::answers::StudentAnswer;

use crate::structure::ComparedFile;

/// What is known about an exercise of a submission.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    Right,
    Wrong,
    NotHandedIn,
    /// Nothing could be judged: a person has to look.
    NeedsALook,
}

impl State {
    pub const ALL: [Self; 4] = [
        Self::Right,
        Self::Wrong,
        Self::NotHandedIn,
        Self::NeedsALook,
    ];

    /// The state in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Wrong => "wrong",
            Self::NotHandedIn => "not handed in",
            Self::NeedsALook => "needs a look",
        }
    }
}

/// What became of an exercise in a submission.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    pub state: State,
    /// Words for the student; empty if there is nothing to say.
    pub message: String,
    /// The fraction of right answers of code that is complete.
    pub fraction: f64,
    /// What is wrong, in one line, by which a table can be sorted.
    pub mistake: String,
    /// The files of the pictures of a program.
    pub pictures: Vec<PathBuf>,
    /// Wrong answers that no known mistake explains.
    pub unnamed: Vec<StudentAnswer>,
}

impl Outcome {
    /// An outcome without answers. The first line of the message says what is wrong.
    pub fn without_answers(state: State, message: &str) -> Self {
        let first = message.lines().next().unwrap_or_default();
        Self {
            state,
            message: message.to_owned(),
            fraction: 0.0,
            mistake: first.to_owned(),
            pictures: Vec::new(),
            unnamed: Vec::new(),
        }
    }

    pub fn right() -> Self {
        Self {
            fraction: 1.0,
            ..Self::without_answers(State::Right, "")
        }
    }
}

/// An exercise or a sheet of a submission, judged.
pub struct Judged {
    /// The stage of the exercise, or `sheet`.
    pub stage: &'static str,
    pub name: String,
    /// The student's file, or the folder of the program; empty if there is none.
    pub file: String,
    /// The files of its code that are compared with those of others.
    pub files: Vec<ComparedFile>,
    /// Whose code is the same but for names, and in which of its files; empty if nobody's is.
    pub same_code_as: String,
    pub outcome: Outcome,
}

/// A student's submission, judged.
pub struct Graded {
    pub name: String,
    /// The name of its files in the folder of the results, which no other student has.
    pub file_name: String,
    pub results: Vec<Judged>,
}
