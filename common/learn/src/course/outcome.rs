//! `Outcome`: what became of an exercise in a submission, and the points for it.

use exercise::StudentAnswer;

use crate::exercise::Exercise;

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

/// Why a program is wrong, to be compared with the programs of others.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// A known mistake, in words.
    Known(String),
    /// Answers that no known mistake explains, and the first of them that is wrong.
    Answers {
        given: Vec<StudentAnswer>,
        first: String,
    },
    /// The program gives no answers: why.
    NoAnswers(String),
}

/// What became of an exercise in a submission.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub state: State,
    /// Words for the student.
    pub message: String,
    /// The fraction of right answers of code that is complete.
    pub fraction: f64,
    /// Of a wrong program.
    pub cause: Option<Cause>,
}

impl Outcome {
    pub fn right() -> Self {
        Self {
            state: State::Right,
            message: "right".to_owned(),
            fraction: 1.0,
            cause: None,
        }
    }

    pub fn not_handed_in() -> Self {
        Self {
            state: State::NotHandedIn,
            message: "not handed in".to_owned(),
            fraction: 0.0,
            cause: None,
        }
    }

    pub fn needs_a_look(why: &str) -> Self {
        Self {
            state: State::NeedsALook,
            message: format!("needs a look: {why}"),
            fraction: 0.0,
            cause: None,
        }
    }

    /// A program without answers, and why, in words of which others have the same first line.
    pub fn without_answers(why: String) -> Self {
        let first = why.lines().next().unwrap_or_default().to_owned();
        Self {
            state: State::Wrong,
            message: why,
            fraction: 0.0,
            cause: Some(Cause::NoAnswers(first)),
        }
    }
}

/// An exercise of a submission, judged.
pub struct Judged {
    pub exercise: &'static Exercise,
    /// The student's file; empty if there is none.
    pub file: String,
    pub outcome: Outcome,
    /// The points for a right solution.
    pub most: f64,
    /// The points for this one; 0 where it needs a look.
    pub points: f64,
}

/// The points for an outcome, of so many for a right one: in part, to a hundredth below, for the
/// fraction of right answers, or none.
pub fn points(outcome: &Outcome, most: f64, in_part: bool) -> f64 {
    match outcome.state {
        State::Right => most,
        State::Wrong if in_part => (most * outcome.fraction * 100.0).floor() / 100.0,
        _ => 0.0,
    }
}

/// A student's submission, judged.
pub struct Graded {
    pub name: String,
    pub results: Vec<Judged>,
}

impl Graded {
    pub fn points(&self) -> f64 {
        in_hundredths(self.results.iter().map(|judged| judged.points).sum())
    }

    pub fn most(&self) -> f64 {
        in_hundredths(self.results.iter().map(|judged| judged.most).sum())
    }

    /// The number of exercises in a state.
    pub fn count(&self, state: State) -> usize {
        let states = self.results.iter().map(|judged| judged.outcome.state);
        states.filter(|found| *found == state).count()
    }
}

/// A sum of points without the rounding of the sum.
fn in_hundredths(sum: f64) -> f64 {
    (sum * 100.0).round() / 100.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_right_solution_has_all_points() {
        let mut wrong = Outcome::without_answers("not yet".to_owned());
        assert_eq!(points(&wrong, 2.0, true), 0.0);
        wrong.fraction = 0.375;
        assert_eq!(points(&wrong, 2.0, true), 0.75);
        assert_eq!(points(&wrong, 2.0, false), 0.0);
        // One answer of a thousand is wrong.
        wrong.fraction = 0.999;
        assert_eq!(points(&wrong, 1.0, true), 0.99);
        assert_eq!(points(&Outcome::right(), 1.5, false), 1.5);
        assert_eq!(points(&Outcome::needs_a_look("2 copies"), 1.5, true), 0.0);
    }
}
