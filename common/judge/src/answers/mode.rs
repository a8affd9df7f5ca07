//! `Mode`: for whom the program of a check runs, as the variable [`MODE`] of its environment says.

use std::env;

/// The variable with the name of a mode.
pub const MODE: &str = "EXERCISE_MODE";

/// The variable with the longest time in seconds that a student's check may take.
pub const SECONDS: &str = "LEARN_SECONDS";

/// The exit code of the program of a check if parts of the student's code are still missing.
pub const BEGUN: u8 = 3;

/// For whom the program of a check runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// A student: it compares the answers with the right ones. Each line of its words begins with
    /// [`WORDS_MARK`](crate::answers::WORDS_MARK).
    #[default]
    Student,
    /// A student whose shape it asks the rays of the corpus, and nothing else.
    Corpus,
    /// A grader, who compares: it prints the answers.
    Grader,
    /// The author of right answers or of a known mistake: it prints the answers, and a record of them with how far each may move.
    Mistake,
}

impl Mode {
    const ALL: [Self; 4] = [Self::Student, Self::Corpus, Self::Grader, Self::Mistake];

    /// The value of the variable.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Student => "student",
            Self::Corpus => "corpus",
            Self::Grader => "grader",
            Self::Mistake => "mistake",
        }
    }

    /// The mode that the environment says.
    #[must_use]
    pub fn of_environment() -> Self {
        let name = env::var(MODE).unwrap_or_default();
        let named = Self::ALL.into_iter().find(|mode| mode.name() == name);
        named.unwrap_or_default()
    }

    /// Whether it prints the answers, which somebody else compares.
    #[must_use]
    pub const fn prints_answers(self) -> bool {
        matches!(self, Self::Grader | Self::Mistake)
    }
}
