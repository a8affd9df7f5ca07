//! The output of the program of a check: its words to a student, and the answers to a grader.

use crate::answers::{Painted, Record, RightAnswer, StudentAnswer, text};

/// Sets the answers apart from what a program prints besides, which is before it.
pub const MARK: char = '\u{1c}';

/// The line before the words about a picture.
const RIGHT_PICTURE: &str = "the picture is right";
const WRONG_PICTURE: &str = "the picture is wrong";

/// Begins a line of a check's words to a student, and so sets it apart from what the student's program prints.
pub const WORDS_MARK: char = '\u{1e}';

/// The mark, two lines for each question, its words and the answer, and those of the picture. Whether the answers are
/// right is not known to the program.
#[must_use]
pub fn print_answers(answers: &[StudentAnswer], painted: Option<&Painted>) -> String {
    let mut printed = MARK.to_string();
    for StudentAnswer { question, answer } in answers {
        let answer = match answer {
            Some(answer) => format!("= {}", text::answer(answer)),
            None => "!".to_owned(),
        };
        printed.extend(["? ", question, "\n", &answer, "\n"]);
    }
    if let Some(painted) = painted {
        let heading = [WRONG_PICTURE, RIGHT_PICTURE][usize::from(painted.is_right)];
        printed.extend([heading, "\n", &painted.words]);
    }
    printed
}

/// The answers in the output of a program, and its picture. A line that no program has written so ends them.
#[must_use]
pub fn read_answers(output: &str) -> (Vec<StudentAnswer>, Option<Painted>) {
    let text = output.split(MARK).nth(1).unwrap_or_default();
    let mut answers = Vec::new();
    let mut lines = text.lines();
    while let Some(first) = lines.next() {
        if [WRONG_PICTURE, RIGHT_PICTURE].contains(&first) {
            let painted = Painted {
                is_right: first == RIGHT_PICTURE,
                words: lines.collect::<Vec<_>>().join("\n"),
            };
            return (answers, Some(painted));
        }
        let given = lines.next().and_then(|answer| read_answer(first, answer));
        let Some(given) = given else {
            break;
        };
        answers.push(given);
    }
    (answers, None)
}

/// The answers in the record that a program has printed for its author, as right ones.
#[must_use]
pub fn read_right_answers(output: &str) -> Vec<RightAnswer> {
    let (_, text) = output.rsplit_once(MARK).unwrap_or_default();
    let record = Record::read(text).unwrap_or_default();
    let questions = record.questions.into_iter();
    questions.map(|question| question.right).collect()
}

fn read_answer(question: &str, answer: &str) -> Option<StudentAnswer> {
    let question = question.strip_prefix("? ")?.to_owned();
    let answer = match answer.strip_prefix("= ") {
        Some(mut answer) => Some(text::take_answer(&mut answer)?),
        None => None,
    };
    Some(StudentAnswer { question, answer })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answers::Answer;

    #[test]
    fn answers_are_read_as_they_were_printed() {
        let answer = Answer::named("t", 0.1).and("", "x; y = \n\"".to_owned());
        let answers = [Some(answer), None].map(|answer| StudentAnswer {
            question: "at 1".to_owned(),
            answer,
        });
        for is_right in [true, false] {
            let painted = Painted {
                is_right,
                words: "two\nlines".to_owned(),
            };
            let printed = print_answers(&answers, Some(&painted));
            let output = format!("a word of the student\n{printed}");
            assert_eq!(read_answers(&output), (answers.to_vec(), Some(painted)));
        }
        let printed = print_answers(&answers, None);
        assert_eq!(read_answers(&printed), (answers.to_vec(), None));
        assert_eq!(read_answers("exit 0"), (Vec::new(), None));
    }
}
