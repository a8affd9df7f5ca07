//! In a browser nothing is judged: a page of the book asks for the pictures by the students' code.

use std::cell::RefCell;
use std::process::ExitCode;

use common::{Error, Image};
use page::{Reply, pixels, settings};

use super::Entry;
use super::exercise::{Exercise, StudentPicture, own_settings};
use super::folder::StageFolder;

/// Paints the picture of this name, with the settings as numbers; none if it is another one than
/// the exercise's.
type Paint = Box<dyn Fn(&str, &[f64]) -> Result<Option<Image>, Error>>;

/// The numbers of this name in the answers to the first question of an exercise, with each of these inputs instead of
/// its own.
type Ask = Box<dyn Fn(&str, &mut dyn Iterator<Item = &[f64]>) -> Vec<f64>>;

/// An exercise with the student's code in it.
struct Yours {
    name: &'static str,
    paint: Paint,
    ask: Ask,
}

thread_local! {
    /// The exercises of the module.
    static YOURS: RefCell<Vec<Yours>> = RefCell::default();
}

/// Keeps the exercises for the page.
#[must_use]
pub fn run(folder: &StageFolder, entries: Vec<Entry>) -> ExitCode {
    for entry in entries {
        keep(*folder, entry.name, (entry.exercise)());
    }
    ExitCode::SUCCESS
}

fn keep(folder: StageFolder, name: &'static str, exercise: Exercise<()>) {
    let picture = exercise.picture;
    let answer = exercise.forms.into_iter().next().map(|form| form.answer);
    let ask = move |part: &str, inputs: &mut dyn Iterator<Item = &[f64]>| {
        let Some(answer) = &answer else {
            return Vec::new();
        };
        let answers = inputs.map(|input| answer(&(), input));
        answers
            .map(|answer| answer.number(part).unwrap_or(f64::NAN))
            .collect()
    };
    let paint = move |wanted: &str, numbers: &[f64]| match &picture {
        StudentPicture::Scene(scene, render) => {
            let stage = folder.stage();
            if wanted != format!("{}-{scene}", stage.name) {
                return Ok(None);
            }
            let settings = settings(&stage.scene(scene)?.defaults, numbers)?;
            render(&(), &settings).map(Some)
        }
        StudentPicture::Own(render) if wanted.contains("-exercise-") => {
            render(&(), &own_settings()?).map(Some)
        }
        _ => Ok(None),
    };
    let (paint, ask): (Paint, Ask) = (Box::new(paint), Box::new(ask));
    YOURS.with_borrow_mut(|all| all.push(Yours { name, paint, ask }));
}

/// Answers `EXERCISE PICTURE`, with the settings as numbers: the picture by the student's code, or
/// nothing if the exercise does not draw it. `EXERCISE answers NAME` takes the length of an input and inputs, and gives
/// the numbers of this name in the code's answers.
fn call(request: &str, numbers: &[f64]) -> Result<Reply, String> {
    let (exercise, picture) = request.split_once(' ').unwrap_or_default();
    YOURS.with_borrow(|all| {
        let Some(yours) = all.iter().find(|yours| yours.name == exercise) else {
            return Ok(Reply::default());
        };
        if let (Some(part), [length, inputs @ ..]) = (picture.strip_prefix("answers "), numbers) {
            let mut inputs = inputs.chunks((*length as usize).max(1));
            return Ok(Reply::default().with("answers", (yours.ask)(part, &mut inputs)));
        }
        let painted = (yours.paint)(picture, numbers).map_err(|error| error.to_string())?;
        Ok(painted.as_ref().map(pixels).unwrap_or_default())
    })
}

/// Answers the request of a page, which lies in the module's memory.
#[expect(unsafe_code, reason = "exporting a name is `unsafe`; no code here is")]
#[unsafe(no_mangle)]
extern "C" fn answer() -> bool {
    page::answer_request(call)
}
