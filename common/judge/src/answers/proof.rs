//! Proves that a known mistake of a record is wrong, and that it is told from all others.

use crate::answers::{KnownMistake, QuestionLine, Record, StudentAnswer, Verdict, verdict};

impl Record {
    /// The verdict on a program that answers these questions as this mistake is recorded. The error
    /// says why the mistake does not belong into the record.
    pub fn prove(&self, mistake: &KnownMistake, questions: &[String]) -> Result<Verdict, String> {
        for (number, (answer, _)) in &mistake.answers {
            let difference = |of: &QuestionLine| of.right.difference(answer);
            let difference = self.questions.get(*number).map(difference);
            if !matches!(difference, Some(Ok(Some(_)))) {
                return Err(format!("its answer {} is not wrong", number + 1));
            }
        }
        let mut given = Vec::new();
        for (answer, question) in mistake.answers(&self.questions).into_iter().zip(questions) {
            given.push(StudentAnswer {
                question: question.clone(),
                answer: Some(answer),
            });
        }
        // Of several mistakes that explain as much, a verdict names the first.
        let mut reversed = self.clone();
        reversed.mistakes.reverse();
        for record in [&reversed, self] {
            let known = verdict(record, &given).known;
            let known = known.as_deref().unwrap_or("none");
            if !known.ends_with(&format!(" that {}", mistake.overlooks)) {
                return Err(format!("it is not recognised: {known}"));
            }
        }
        Ok(verdict(self, &given))
    }
}
