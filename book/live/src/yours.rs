//! The scenes that students' code draws, rendered for a page of the book: for browsers, this
//! takes the place of `judge.rs` in the crate `testing`.

use std::cell::RefCell;
use std::process::ExitCode;

use common::{Error, Image, Settings, Stage};

use super::{Check, Code, Mistakes};
use answer::Answer;

// The page speaks with this module as with the module of the lessons.
#[path = "answer.rs"]
mod answer;
#[path = "exchange.rs"]
mod exchange;
#[path = "exports.rs"]
mod exports;

thread_local! {
    static YOURS: RefCell<Vec<(&'static str, Code)>> = RefCell::default();
    /// The name of the wanted picture, and its settings.
    static WANTED: RefCell<(String, Vec<f64>)> = RefCell::default();
}

/// Keeps the code of an exercise for the page.
#[must_use]
pub fn judge(_: &str, name: &'static str, code: Code, _: Mistakes) -> ExitCode {
    YOURS.with_borrow_mut(|yours| yours.push((name, code)));
    ExitCode::SUCCESS
}

/// Answers `EXERCISE PICTURE`, with the settings as numbers: the picture by the student's
/// code, or nothing if the exercise does not draw it.
fn call(request: &str, numbers: &[f64]) -> Result<Answer, String> {
    let (exercise, picture) = request.split_once(' ').unwrap_or_default();
    WANTED.set((picture.to_owned(), numbers.to_owned()));
    // A picture of an exercise, and of no scene, is painted if somebody looks.
    let mut check = Check::new(picture.contains("-exercise-"), None);
    let codes = YOURS.with_borrow(Vec::clone);
    if let Some((_, code)) = codes.iter().find(|(name, _)| *name == exercise) {
        (code.check)(&mut check);
    }
    let picture = check.picture.as_ref().map(exchange::pixels);
    check.first.map_or(Ok(picture.unwrap_or_default()), Err)
}

impl Check {
    /// Renders a scene of the stage with the student's code, if the page wants it.
    pub fn scene(
        &mut self,
        stage: &Stage,
        name: &str,
        render: impl FnOnce(&Settings) -> Result<Image, Error>,
    ) {
        let (picture, numbers) = WANTED.with_borrow(Clone::clone);
        if picture != format!("{}-{name}", stage.name) {
            return;
        }
        let scene = stage.scene(name);
        let settings = scene.and_then(|scene| exchange::settings(&scene.defaults, &numbers));
        match settings.and_then(|settings| render(&settings)) {
            Ok(image) => self.picture = Some(image),
            Err(error) => self.conclude(Some(error.to_string())),
        }
    }
}
