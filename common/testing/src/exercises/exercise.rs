//! `Exercise`: the questions and the picture of an exercise.

use std::rc::Rc;

use common::{Error, Image, Settings, Size};
use judge::answers::{Answer, Input, Question, QuestionLine, Record};

/// The answer of code of the type `C` to a question with other numbers.
pub type AnswerTo<C> = Box<dyn Fn(&C, &[f64]) -> Answer>;

/// Renders a picture with code of the type `C`.
pub type Render<C> = Box<dyn Fn(&C, &Settings) -> Result<Image, Error>>;

/// An exercise about code of the type `C`, such as a function.
pub struct Exercise<C> {
    /// The questions of its file, in their order; none before the file is read.
    pub questions: Vec<CodeQuestion<()>>,
    /// The forms of the questions that the exercise's file asks.
    pub forms: Vec<Form<C>>,
    /// The picture that the code paints.
    pub picture: StudentPicture<C>,
}

/// An exercise without questions.
impl<C> Default for Exercise<C> {
    fn default() -> Self {
        Self {
            questions: Vec::new(),
            forms: Vec::new(),
            picture: StudentPicture::None,
        }
    }
}

impl<C: 'static> Exercise<C> {
    /// An exercise whose file asks questions of one form, to which code gives this answer.
    pub fn asked<I: Input + Default + 'static, A: Into<Answer> + 'static>(
        answer: fn(&C, I) -> A,
    ) -> Self {
        Self {
            forms: vec![Form::new(answer)],
            ..Self::default()
        }
    }

    /// The exercise with this code in it. Whoever asks it need not know the type of the code, and is compiled once.
    pub fn with_code(self, code: C) -> Exercise<()> {
        let code = Rc::new(code);
        let forms = self.forms.into_iter();
        Exercise {
            questions: self.questions,
            forms: forms.map(|form| form.with_code(&code)).collect(),
            picture: match self.picture {
                StudentPicture::None => StudentPicture::None,
                StudentPicture::Scene(name, render) => {
                    StudentPicture::scene(name, move |(), settings| render(&code, settings))
                }
                StudentPicture::Own(render) => {
                    StudentPicture::own(move |(), settings| render(&code, settings))
                }
            },
        }
    }
}

impl Exercise<()> {
    /// Takes the questions of the exercise's file.
    pub fn take_questions(&mut self, record: &Record) -> Result<(), String> {
        for line in &record.questions {
            let form = self.forms.get(line.form);
            let form =
                form.ok_or_else(|| format!("the check has no form for \"{}\"", line.words))?;
            self.questions.push((form.question)(line)?);
        }
        if self.questions.is_empty() {
            return Err("it asks nothing".to_owned());
        }
        Ok(())
    }
}

/// The picture that a student's code paints.
pub enum StudentPicture<C> {
    /// None.
    None,
    /// A scene of the stage, which is compared with its locked picture.
    Scene(&'static str, Render<C>),
    /// A small picture that is only looked at.
    Own(Render<C>),
}

/// The settings of a picture that is only looked at.
pub(super) fn own_settings() -> Result<Settings, Error> {
    Ok(Settings {
        size: Size::new(320, 240)?,
        ..Settings::default()
    })
}

impl<C> StudentPicture<C> {
    /// The scene of the stage of this name, with the code in it.
    pub fn scene(
        name: &'static str,
        render: impl Fn(&C, &Settings) -> Result<Image, Error> + 'static,
    ) -> Self {
        Self::Scene(name, Box::new(render))
    }

    /// A picture by the code, to be looked at.
    pub fn own(render: impl Fn(&C, &Settings) -> Result<Image, Error> + 'static) -> Self {
        Self::Own(Box::new(render))
    }
}

/// A question, and how code answers it, also with other numbers.
pub struct CodeQuestion<C> {
    /// The question.
    pub question: Question,
    /// The code's answer to the question with these numbers.
    pub answer: AnswerTo<C>,
}

/// The answers of this code.
fn answer_with_code<C: 'static>(answer: AnswerTo<C>, code: &Rc<C>) -> AnswerTo<()> {
    let code = Rc::clone(code);
    Box::new(move |(), numbers| answer(&code, numbers))
}

/// Makes a question of a line. An error says what the question takes.
type QuestionOf<C> = Box<dyn Fn(&QuestionLine) -> Result<CodeQuestion<C>, String>>;

/// A form of questions that the exercise's file asks.
pub struct Form<C> {
    /// Makes a question of a line.
    question: QuestionOf<C>,
    /// The code's answer to a question of these numbers, which has nothing else.
    pub answer: AnswerTo<C>,
}

impl<C: 'static> Form<C> {
    /// The form of the questions to which code gives this answer.
    pub fn new<I: Input + Default + 'static, A: Into<Answer> + 'static>(
        answer: impl Fn(&C, I) -> A + Copy + 'static,
    ) -> Self {
        Self {
            question: Box::new(move |line| {
                let (input, question) = line.read::<I>()?;
                Ok(CodeQuestion {
                    question,
                    answer: answer_to(input, answer),
                })
            }),
            answer: answer_to(I::default(), answer),
        }
    }

    fn with_code(self, code: &Rc<C>) -> Form<()> {
        let of_question = Rc::clone(code);
        Form {
            question: Box::new(move |line| {
                let CodeQuestion { question, answer } = (self.question)(line)?;
                let answer = answer_with_code(answer, &of_question);
                Ok(CodeQuestion { question, answer })
            }),
            answer: answer_with_code(self.answer, code),
        }
    }
}

/// The answer to this input with other numbers.
fn answer_to<C: 'static, I: Input + 'static, A: Into<Answer> + 'static>(
    input: I,
    answer: impl Fn(&C, I) -> A + 'static,
) -> AnswerTo<C> {
    Box::new(move |code, numbers| answer(code, input.clone().with_numbers(numbers)).into())
}
