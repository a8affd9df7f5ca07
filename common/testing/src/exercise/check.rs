//! `Check`: compares the results of a student's code with the right ones.

use common::{Error, Image, Settings, Size};
use measure::Stage;
use measure::extremes::{Bound, Case, Outcome};
use program::picture_name;

use super::picture;

/// Compares the results of the student's code with the right ones.
#[derive(Default)]
pub struct Check {
    pub(super) compared: usize,
    /// The last comparison, after which a panic happens.
    pub(super) last: String,
    /// The differences, with their errors.
    pub(super) wrong: Vec<String>,
    /// Whether somebody looks at pictures.
    pub(super) is_watched: bool,
    pub(super) picture: Option<Image>,
}

impl Check {
    /// Compares an outcome with the exact one: the name of the quantity, its exact
    /// value, the largest error that counts as right, and the result of the student's
    /// code.
    pub fn expect(
        &mut self,
        what: impl Into<String>,
        exact: impl Into<Outcome>,
        bound: Bound,
        got: impl Into<Outcome>,
    ) {
        let case = Case::new("", what, exact, bound, got);
        let wrong = format!("{}: {}", case.what, case.comparison());
        self.conclude(case.holds().then_some(()).ok_or(wrong));
        self.last = case.what;
    }

    fn conclude(&mut self, result: Result<(), String>) {
        self.compared += 1;
        self.wrong.extend(result.err());
    }

    /// Renders a scene of the stage with the student's code, and compares the picture
    /// with the locked one, unless an earlier comparison of this check has failed: then
    /// the numbers say more.
    pub fn scene(
        &mut self,
        stage: &Stage,
        name: &str,
        render: impl FnOnce(&Settings) -> Result<Image, Error>,
    ) {
        if !self.wrong.is_empty() {
            return;
        }
        let compared = stage.scene(name).and_then(|scene| {
            let image = self.picture.insert(render(&scene.defaults)?);
            let locked = picture::in_book(&picture_name(stage, scene));
            Ok(picture::compare(&locked, image, self.is_watched))
        });
        let result = compared.unwrap_or_else(|error| Err(error.to_string()));
        self.conclude(result.map_err(|wrong| format!("the picture of scene {name}: {wrong}")));
    }

    /// Paints a small picture with the student's code, if somebody looks at it.
    pub fn picture(&mut self, paint: impl FnOnce(&Settings) -> Result<Image, Error>) {
        if self.is_watched {
            let size = Size::new(320, 240).map_err(Error::from);
            let painted = size.and_then(|size| {
                paint(&Settings {
                    size,
                    ..Settings::default()
                })
            });
            match painted {
                Ok(image) => self.picture = Some(image),
                Err(error) => self.conclude(Err(format!("a picture: {error}"))),
            }
        }
    }
}
