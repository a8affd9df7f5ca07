//! Questions of exercises, their right answers, and the verdict on other answers.
//!
//! A [`Question`] is a value: words, numbers, and whether they are simple. The
//! solution of an exercise answers all its questions; these answers, with how far another right
//! answer may be from them, are its [`Record`], a text file beside the solutions. The questions
//! stand there, too. A student's
//! program answers the same questions, and [`verdict`] compares: it is the only comparison of
//! `cargo learn`, of the grader, of the tests and of the book's pages, and none of them needs a
//! solution for it.

mod answer;
mod input;
mod known_mistake;
mod mode;
mod proof;
mod question;
mod question_line;
mod record;
mod renewal;
mod right_answer;
mod student_output;
mod text;
mod tolerance;
mod verdict;

pub use answer::{Answer, assert_close, assert_close_about};
pub use input::{Arguments, Input};
pub use known_mistake::KnownMistake;
pub use mode::{BEGUN, MODE, Mode, SECONDS};
pub use question::Question;
pub use question_line::QuestionLine;
pub use record::Record;
pub use right_answer::RightAnswer;
pub use student_output::{MARK, WORDS_MARK, print_answers, read_answers, read_right_answers};
pub use tolerance::Tolerance;
pub use verdict::{Painted, StudentAnswer, Verdict, verdict};
