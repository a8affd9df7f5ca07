//! `Findings`: the answers and the picture of an exercise with code in it.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use common::difference::{
    compare_with_file, largest, leave_pictures, remove_pictures, worst_pixel,
};
use common::steps::with_chosen_pixel;
use common::{Error, Image, Settings, divergence, picture_file};
use judge::answers::{Answer, Painted, Record, RightAnswer, StudentAnswer, Verdict, verdict};

use super::exercise::{AnswerTo, Exercise, StudentPicture, own_settings};
use super::folder::StageFolder;
use super::hang::note;
use super::{Missing, take_missing};

/// What a program finds, beside its answers.
#[derive(Default)]
pub struct Findings {
    /// The missing parts of the code.
    pub missing: Vec<Missing>,
    /// The answers.
    pub given: Vec<StudentAnswer>,
    /// The picture, also of code that is wrong.
    pub image: Option<Image>,
    /// The comparison of the picture.
    pub painted: Option<Painted>,
    /// Messages.
    pub verdict: Verdict,
}

/// Who looks at a picture: a student, also while answers are wrong; a grader compares it, and
/// no picture of the difference is saved.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Reader {
    Student,
    Grader,
}

/// The comparison of a picture with the lesson's.
struct Comparison {
    /// What messages call the picture.
    name: String,
    /// The difference; none if the picture is right.
    difference: Option<String>,
    /// The first step of a pixel in which the student's code and the lesson part.
    divergence: Option<String>,
}

impl Exercise<()> {
    /// Its answers as right ones. Where the code panics, its answer is none.
    #[must_use]
    pub fn right_answers(&self) -> Vec<RightAnswer> {
        let mut answers = Vec::new();
        for asked in &self.questions {
            let code = |input: &[f64]| answer_of(&asked.answer, input).unwrap_or_default();
            answers.push(RightAnswer::new(&asked.question, &code));
        }
        answers
    }

    /// Its answers to all questions.
    fn given(&self) -> Vec<StudentAnswer> {
        let mut given = Vec::new();
        for asked in &self.questions {
            note(&asked.question.text);
            given.push(StudentAnswer {
                question: asked.question.text.clone(),
                answer: answer_of(&asked.answer, &asked.question.input),
            });
        }
        given
    }

    /// Runs the examples of the code, asks it, lets it paint, and compares, if there is a record.
    pub fn run(
        &self,
        examples: fn(),
        record: Option<&Record>,
        folder: &StageFolder,
        reader: Reader,
    ) -> Findings {
        take_missing();
        note("an example at the end of the file");
        let example_fails = catch_unwind(examples).is_err();
        let given = self.given();
        // Then an example and the picture panic, too, and the questions say where.
        let panics = given.iter().any(|given| given.answer.is_none());
        let mut before = Vec::new();
        if example_fails && !panics {
            let fails = "an example at the end of the file fails, with the message above";
            before.push(fails.to_owned());
        }
        let compared = record.map(|record| verdict(record, &given));
        let mut verdict = compared.unwrap_or_default();
        let missing = take_missing();
        let mut image = None;
        note("the picture");
        let paint = || match &self.picture {
            // Unfinished code has none of a scene.
            StudentPicture::Scene(name, render) if missing.is_empty() => {
                let render = |settings: &Settings| render(&(), settings);
                compare_scene(folder, name, reader, &render, &mut image).map(Some)
            }
            StudentPicture::Own(render) => {
                image = Some(render(&(), &own_settings()?)?);
                Ok(None)
            }
            _ => Ok(None),
        };
        let painted = match catch_unwind(AssertUnwindSafe(paint)) {
            Ok(Ok(compared)) => compared.map(|compared| compared.painted()),
            Ok(Err::<_, Error>(error)) => {
                before.push(format!("the picture: {error}"));
                None
            }
            Err(_) => {
                if !panics {
                    before.push("the picture: it panics, with the message above".to_owned());
                }
                None
            }
        };
        verdict.wrong.splice(0..0, before);
        if let (Some(_), Some(painted)) = (record, &painted) {
            verdict.add_picture(painted);
        }
        Findings {
            missing,
            given,
            image,
            painted,
            verdict,
        }
    }
}

/// The answer to a question of these numbers; none if the code panics.
pub fn answer_of(answer: &AnswerTo<()>, numbers: &[f64]) -> Option<Answer> {
    catch_unwind(AssertUnwindSafe(|| answer(&(), numbers))).ok()
}

/// Renders a scene of the stage with the student's code, and compares the picture with the locked
/// one. The worst pixel is traced by the lesson, too.
fn compare_scene(
    folder: &StageFolder,
    name: &str,
    reader: Reader,
    render: &dyn Fn(&Settings) -> Result<Image, Error>,
    painted: &mut Option<Image>,
) -> Result<Comparison, Error> {
    let stage = folder.stage();
    let scene = stage.scene(name)?;
    let settings = StageFolder::settings(&scene);
    let file = folder.expected(name);
    let expected = picture_file::open(&file).ok();
    let worst = move |image: &Image| worst_pixel(expected.as_ref()?, image);
    let (image, yours) = with_chosen_pixel(worst, || render(&settings));
    let image = painted.insert(image?);
    let mut difference = difference(&file, image);
    // A grader's sandbox has no place for pictures.
    if reader != Reader::Grader {
        let scratch = folder.pictures();
        match &mut difference {
            Some(words) => *words = leave_pictures(&scratch, &file, image, words),
            None => remove_pictures(&scratch, &file),
        }
    }
    let mut divergence = None;
    if let (Ok(rays), Some(yours)) = (scene.rays(), yours) {
        let lesson = rays.trace(&settings, yours.pixel)?;
        divergence = lesson.first_divergence(&yours, "yours", divergence::ROUNDING);
    }
    Ok(Comparison {
        name: format!("the picture of scene {name}"),
        difference,
        // What an earlier chapter explains is not what this exercise asks for.
        divergence: divergence.map(|divergence| match divergence.section {
            section if section.starts_with(stage.name) => divergence.to_string(),
            _ => divergence.difference(),
        }),
    })
}

/// The difference of a picture from the one in a file; none if no channel differs by more than 1 of
/// 255.
pub fn difference(file: &Path, image: &Image) -> Option<String> {
    let words = compare_with_file(file, image).err()?;
    let expected = picture_file::open(file).ok();
    let most = expected.and_then(|expected| largest(&expected, image));
    most.is_none_or(|(_, most)| most > 1).then_some(words)
}

impl Comparison {
    /// The words about it. A picture that is right acquits no code: the scene does not show what is wrong.
    fn painted(&self) -> Painted {
        let name = &self.name;
        let words = match (&self.difference, &self.divergence) {
            (None, None) => format!("{name} does not show it"),
            (None, Some(_)) => format!("{name} has the right colours"),
            (Some(difference), _) => format!("{name}: {difference}"),
        };
        Painted {
            is_right: self.difference.is_none(),
            words: match &self.divergence {
                Some(divergence) => format!("{words}\n{divergence}"),
                None => words,
            },
        }
    }
}
