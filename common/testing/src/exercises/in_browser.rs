//! In a browser nothing is judged: a page of the book asks for the pictures by the students' code.

use std::cell::RefCell;
use std::process::ExitCode;

use common::{Error, Image};
use page::{Answer, pixels, settings};

use super::exercise::{Exercise, Picture, own_settings};
use super::folder::StageFolder;

/// Paints the picture of this name, with the settings as numbers; none if it is another one than
/// the exercise's.
type Paint = Box<dyn Fn(&str, &[f64]) -> Result<Option<Image>, Error>>;

thread_local! {
    /// The exercises of the module, with the students' code in them.
    static YOURS: RefCell<Vec<(&'static str, Paint)>> = RefCell::default();
}

/// Keeps the code of an exercise for the page.
#[must_use]
pub fn judge<C: 'static>(
    folder: &StageFolder,
    name: &'static str,
    exercise: Exercise<C>,
    yours: C,
    _: fn(),
) -> ExitCode {
    let (folder, picture) = (*folder, exercise.picture);
    let paint = move |wanted: &str, numbers: &[f64]| match &picture {
        Picture::Scene(scene, render) => {
            let stage = folder.stage();
            if wanted != format!("{}-{scene}", stage.name) {
                return Ok(None);
            }
            let settings = settings(&stage.scene(scene)?.defaults, numbers)?;
            render(&yours, &settings).map(Some)
        }
        Picture::Own(render) if wanted.contains("-exercise-") => {
            render(&yours, &own_settings()?).map(Some)
        }
        _ => Ok(None),
    };
    YOURS.with_borrow_mut(|yours| yours.push((name, Box::new(paint))));
    ExitCode::SUCCESS
}
/// Answers `EXERCISE PICTURE`, with the settings as numbers: the picture by the student's code, or
/// nothing if the exercise does not draw it.
fn call(request: &str, numbers: &[f64]) -> Result<Answer, String> {
    let (exercise, picture) = request.split_once(' ').unwrap_or_default();
    YOURS.with_borrow(|yours| {
        let Some((_, paint)) = yours.iter().find(|(name, _)| *name == exercise) else {
            return Ok(Answer::default());
        };
        let painted = paint(picture, numbers).map_err(|error| error.to_string())?;
        Ok(painted.as_ref().map(pixels).unwrap_or_default())
    })
}

/// Answers the request of a page, which lies in the module's memory.
#[expect(unsafe_code, reason = "exporting a name is `unsafe`; no code here is")]
#[unsafe(no_mangle)]
extern "C" fn answer() -> bool {
    page::answer_request(call)
}
