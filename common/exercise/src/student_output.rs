//! `StudentOutput`: what a student's program prints for a grader, its answers and its picture.

use std::fmt::{self, Write};

use common::{Color, Image, Size, Transfer};

use crate::{Question, StudentAnswer, text};

/// Sets the answers apart from what a program prints besides, which is before it.
pub const MARK: char = '\u{1c}';

/// With this variable in the environment, each line of a check begins with a mark, which sets it
/// apart from what the student's program prints.
pub const MARKED: &str = "EXERCISE_MARKED";

/// Begins a line that all students read, such as what is wrong.
pub const WORDS_MARK: char = '\u{1e}';

/// Begins a line for those who want to know more, such as how exact a right answer is.
pub const REMARK_MARK: char = '\u{1f}';

/// The answers of a student's program, and the picture of the scene that it paints.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StudentOutput {
    /// The answers.
    pub answers: Vec<StudentAnswer>,
    /// The picture, if there is one.
    pub picture: Option<Image>,
}

/// Two lines for each question, with its words and the answer, and one for the picture: columns,
/// rows, and the bytes of red, green and blue of each pixel as hexadecimal digits.
impl fmt::Display for StudentOutput {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_char(MARK)?;
        for StudentAnswer { question, answer } in &self.answers {
            writeln!(f, "? {}", question.text)?;
            match answer {
                Some(answer) => writeln!(f, "= {}", text::answer(answer))?,
                None => writeln!(f, "!")?,
            }
        }
        if let Some(picture) = &self.picture {
            let size = picture.size();
            write!(f, "picture {} {} ", size.width(), size.height())?;
            for byte in picture.to_rgb8(Transfer::Linear) {
                write!(f, "{byte:02x}")?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

impl StudentOutput {
    /// The answers in the output of a program. A line that no program has written so ends them.
    #[must_use]
    pub fn read(output: &str) -> Self {
        let (_, text) = output.split_once(MARK).unwrap_or_default();
        let mut printed = Self::default();
        let mut lines = text.lines();
        while let Some(line) = lines.next() {
            if let Some(picture) = line.strip_prefix("picture ") {
                printed.picture = read_picture(picture);
                break;
            }
            let Some(given) = lines.next().and_then(|answer| read_given(line, answer)) else {
                break;
            };
            printed.answers.push(given);
        }
        printed
    }
}

fn read_given(question: &str, answer: &str) -> Option<StudentAnswer> {
    let question = Question {
        text: question.strip_prefix("? ")?.to_owned(),
        ..Question::default()
    };
    let answer = match answer.strip_prefix("= ") {
        Some(mut answer) => Some(text::take_answer(&mut answer)?),
        None => None,
    };
    Some(StudentAnswer { question, answer })
}

fn read_picture(text: &str) -> Option<Image> {
    let mut words = text.split(' ');
    let [width, height] = [words.next()?, words.next()?].map(|number| number.parse().ok());
    let size = Size::new(width?, height?).ok()?;
    let mut bytes = Vec::new();
    for digits in words.next()?.as_bytes().chunks(2) {
        let digits = str::from_utf8(digits).ok()?;
        bytes.push(u8::from_str_radix(digits, 16).ok()?);
    }
    let pixels = bytes.as_chunks().0;
    if pixels.len() as u64 != size.pixels() as u64 {
        return None;
    }
    let mut image = Image::black(size).ok()?;
    for (pixel, bytes) in image.pixels_mut().iter_mut().zip(pixels) {
        *pixel = Color::from_bytes(*bytes);
    }
    Some(image)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Answer;

    #[test]
    fn answers_are_read_as_they_were_printed() {
        let answer = Answer::named("t", 0.1).and("", "x; y = \n\"".to_owned());
        let answers = [Some(answer), None].map(|answer| StudentAnswer {
            question: Question::default(),
            answer,
        });
        let size = Size::new(3, 2).unwrap();
        let picture = Image::from_fn(size, |x, y| Color::from_bytes([x as u8, y as u8, 255]));
        let printed = StudentOutput {
            answers: answers.to_vec(),
            picture: Some(picture.unwrap()),
        };
        let output = format!("a word of the student\n{printed}");
        assert_eq!(StudentOutput::read(&output), printed);
        // Neither without the picture's last byte, nor with another mark, is it a picture.
        let cut = &output[..output.len() - 3];
        assert_eq!(StudentOutput::read(cut).picture, None);
        assert_eq!(StudentOutput::read("exit 0"), StudentOutput::default());
    }
}
