//! `QuestionLine`: a question as a line of an exercise's file.

use crate::answers::{Input, Question, RightAnswer};

/// A question, as the file of an exercise asks it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct QuestionLine {
    /// The lines above it that ask nothing, such as a comment.
    pub above: String,
    /// The number of its form, from 0.
    pub form: usize,
    /// The words of the form, with `{}` instead of each argument.
    pub words: String,
    /// Whether its numbers are simple, as [`Question`] says.
    pub is_simple: bool,
    /// Its arguments, with `|` between them.
    pub arguments: String,
    /// The right answer; empty if it has none yet.
    pub right: RightAnswer,
}

impl QuestionLine {
    /// The arguments, and the question. An error says what arguments the question takes.
    pub fn read<I: Input>(&self) -> Result<(I, Question), String> {
        let mut arguments = self.arguments.split('|');
        let input = I::read(&mut arguments);
        match input.filter(|_| arguments.next().is_none()) {
            Some(input) => {
                let question = Question::new(&self.words, &input, self.is_simple);
                Ok((input, question))
            }
            None => Err(format!(
                "`{}` is not what \"{}\" takes: an argument for each {{}}, and | between them",
                self.arguments, self.words
            )),
        }
    }
}
