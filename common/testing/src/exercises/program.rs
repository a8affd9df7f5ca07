//! `Program`: an exercise with code that answers its questions and paints its picture.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::rc::Rc;

use common::difference::worst_pixel;
use common::steps::{StepKind, with_chosen_pixel};
use common::{Error, Image, Settings, divergence, picture_file};
use exercise::{
    Answer, Mistake, PictureVerdict, Question, Record, Row, StudentAnswer, Verdict, pictured,
    verdict,
};

use super::assertion::is_rounding;
use super::exercise::{CodeQuestion, Exercise, Picture, Render, own_settings};
use super::folder::StageFolder;
use super::{Missing, found_missing};

/// The answer to a question with other numbers.
type AnswerTo = Box<dyn Fn(&[f64]) -> Answer>;

/// Code that answers the questions of an exercise, with its type erased.
pub struct Program {
    questions: Vec<Question>,
    answers: Vec<AnswerTo>,
    picture: Picture<()>,
    drawing: Option<Render<()>>,
    section_of_rays: Option<&'static str>,
}

/// What a program finds, beside its answers.
#[derive(Default)]
pub struct Findings {
    /// The missing parts of the code.
    pub missing: Vec<Missing>,
    /// The answers.
    pub given: Vec<StudentAnswer>,
    /// The picture, also of code that is wrong.
    pub image: Option<Image>,
    /// What the code draws instead for learners, also while it is unfinished.
    pub drawing: Option<Image>,
    /// Messages.
    pub verdict: Verdict,
}

/// Who looks at a picture: a student, also while answers are wrong; a grader compares it, and
/// no picture of the difference is saved.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Reader {
    Student,
    Grader,
    Author,
}

impl Program {
    /// The program of an exercise with this code.
    pub fn new<C: 'static>(exercise: Exercise<C>, code: C) -> Self {
        let code = Rc::new(code);
        let (mut questions, mut answers) = (Vec::new(), Vec::<AnswerTo>::new());
        for CodeQuestion { question, answer } in exercise.questions.into_iter().flatten() {
            let code = code.clone();
            questions.push(question);
            answers.push(Box::new(move |input| answer(&code, input)));
        }
        let drawing = exercise.drawing.map(|render| -> Render<()> {
            let code = code.clone();
            Box::new(move |(), settings| render(&code, settings))
        });
        let picture = match exercise.picture {
            Picture::None => Picture::None,
            Picture::Scene(name, render) => {
                Picture::scene(name, move |(), settings| render(&code, settings))
            }
            Picture::Own(render) => Picture::own(move |(), settings| render(&code, settings)),
        };
        Self {
            questions,
            answers,
            picture,
            drawing,
            section_of_rays: exercise.section_of_rays,
        }
    }

    /// The scene of the stage that it paints.
    pub fn scene(&self) -> Option<&'static str> {
        match self.picture {
            Picture::Scene(name, _) => Some(name),
            _ => None,
        }
    }

    /// The rows of its answers, which are right.
    pub fn rows(&self, is_about_rounding: bool) -> Vec<Row> {
        let rows = self.questions.iter().zip(&self.answers);
        let rows = rows.map(|(question, answer)| Row::new(question, is_about_rounding, answer));
        rows.collect()
    }

    /// Its answers, as those of code with a mistake.
    pub fn mistake(&self, overlooks: &str, rows: &[Row]) -> Mistake {
        let code = |number: usize, input: &[f64]| self.answers[number](input);
        Mistake::new(overlooks, rows, &self.questions, &code)
    }

    /// Whether a part of its code is missing.
    pub fn is_unfinished(&self) -> bool {
        found_missing().clear();
        self.given();
        !found_missing().is_empty()
    }

    /// Its answers to all questions.
    fn given(&self) -> Vec<StudentAnswer> {
        let asked = self.questions.iter().zip(&self.answers);
        let given = asked.map(|(question, answer)| StudentAnswer {
            question: question.clone(),
            answer: catch_unwind(AssertUnwindSafe(|| answer(&question.input))).ok(),
        });
        given.collect()
    }

    /// Runs the examples of the code, asks it, lets it paint, and compares.
    pub fn run(
        &self,
        examples: fn(),
        record: &Record,
        folder: &StageFolder,
        reader: Reader,
    ) -> Findings {
        found_missing().clear();
        let mut wrong = Vec::new();
        if catch_unwind(examples).is_err_and(|panic| !is_rounding(&message(&*panic))) {
            let fails = "an example at the end of the file fails, with the message above";
            wrong.push(fails.to_owned());
        }
        let given = self.given();
        let verdict_so_far = verdict(record, &given, None);
        let is_right = verdict_so_far.wrong.is_empty();
        let painted = catch_unwind(AssertUnwindSafe(|| self.paint(is_right, folder, reader)));
        let (image, pictured) = painted.unwrap_or_else(|_| {
            wrong.push("it panics, with the message above".to_owned());
            (None, None)
        });
        let drawn = catch_unwind(AssertUnwindSafe(|| self.draw(is_right, reader)));
        let mut verdict = verdict(record, &given, pictured.clone());
        if let Some(pictured) = pictured.filter(|_| !wrong.is_empty()) {
            verdict.note = Some(pictured.beside_wrong_answers());
        }
        verdict.wrong.splice(0..0, wrong);
        Findings {
            missing: found_missing().clone(),
            verdict,
            given,
            image,
            // Code that panics here has panicked above, or says so itself.
            drawing: drawn.unwrap_or_default(),
        }
    }

    /// Paints the picture, and compares that of a scene. After wrong answers, only students see
    /// it, and unfinished code has no picture of a scene.
    fn paint(
        &self,
        is_right: bool,
        folder: &StageFolder,
        reader: Reader,
    ) -> (Option<Image>, Option<PictureVerdict>) {
        let is_shown = is_right || reader != Reader::Author;
        match &self.picture {
            Picture::Scene(name, render) if is_right || is_shown && found_missing().is_empty() => {
                let mut image = None;
                let render = |settings: &Settings| render(&(), settings);
                let pictured = self.scene_picture(folder, name, reader, &render, &mut image);
                let failed = |error| failed(format!("the picture of scene {name}"), &error);
                (image, Some(pictured.unwrap_or_else(failed)))
            }
            Picture::Own(render) if is_shown => {
                let painted = own_settings().and_then(|settings| render(&(), &settings));
                match painted {
                    Ok(image) => (Some(image), None),
                    Err(error) => (None, Some(failed("a picture".to_owned(), &error))),
                }
            }
            _ => (None, None),
        }
    }

    /// Draws for a learner, also unfinished code, and the right code for its author.
    pub fn draw(&self, is_right: bool, reader: Reader) -> Option<Image> {
        let render = self.drawing.as_ref()?;
        let is_seen = match reader {
            Reader::Student => true,
            Reader::Author => is_right,
            Reader::Grader => false,
        };
        if !is_seen {
            return None;
        }
        // Parameters that the code refuses have been asked before.
        own_settings()
            .and_then(|settings| render(&(), &settings))
            .ok()
    }

    /// Renders a scene of the stage with the student's code, and compares the picture with the
    /// locked one. The worst pixel is traced by the lesson, too.
    fn scene_picture(
        &self,
        folder: &StageFolder,
        name: &str,
        reader: Reader,
        render: &dyn Fn(&Settings) -> Result<Image, Error>,
        painted: &mut Option<Image>,
    ) -> Result<PictureVerdict, Error> {
        let stage = folder.stage();
        let scene = stage.scene(name)?;
        let settings = StageFolder::settings(&scene);
        let file = folder.expected(name);
        let expected = picture_file::open(&file).ok();
        let worst = move |image: &Image| worst_pixel(expected.as_ref()?, image);
        let (image, yours) = with_chosen_pixel(worst, || render(&settings));
        let image = painted.insert(image?);
        // A grader's sandbox has no place for it.
        let differences = (reader != Reader::Grader).then(|| folder.pictures());
        let mut pictured = pictured(name, &file, image, differences.as_deref());
        if let (Ok(rays), Some(yours)) = (scene.rays(), yours) {
            let lesson = rays.trace(&settings, yours.pixel)?;
            let mut divergence = lesson.first_divergence(&yours, "yours", divergence::ROUNDING);
            if let (Some(divergence), Some(section)) = (&mut divergence, self.section_of_rays)
                && divergence.step == StepKind::CameraRay
            {
                divergence.section = section;
            }
            pictured.divergence = divergence.map(|divergence| divergence.to_string());
        }
        Ok(pictured)
    }
}

/// The message of a panic.
fn message(panic: &(dyn Any + Send)) -> String {
    let words = panic.downcast_ref::<String>().cloned();
    words.unwrap_or_else(|| panic.downcast_ref().copied().unwrap_or("").to_owned())
}

/// A picture that could not be painted.
fn failed(name: String, error: &Error) -> PictureVerdict {
    PictureVerdict {
        name,
        is_right: false,
        words: error.to_string(),
        divergence: None,
    }
}
