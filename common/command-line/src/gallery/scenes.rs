//! `Scenes`: the scenes of a stage and of a scene file, of which one is shown.

use common::{Error, Scene, Stage};

use crate::opened_file::OpenedFile;

/// The scenes, in a circle.
pub struct Scenes<'a> {
    /// The stage.
    pub stage: &'a Stage,
    /// The scene file, which stands before the scenes of the stage.
    pub file: Option<OpenedFile>,
    /// The number of the scene that is shown.
    pub number: usize,
}

impl Scenes<'_> {
    /// The scene that is shown; none if its file was never right.
    pub fn shown(&self) -> Option<&Scene> {
        match (&self.file, self.number) {
            (Some(file), 0) => file.scene(),
            (Some(_), number) => self.stage.scenes.get(number - 1),
            (None, number) => self.stage.scenes.get(number),
        }
    }

    /// The scene file, if its scene is shown.
    pub fn shown_file(&self) -> Option<&OpenedFile> {
        self.file.as_ref().filter(|_| self.number == 0)
    }

    /// What is wrong with the file that is shown, as it is now.
    pub fn error(&self) -> Option<&Error> {
        self.shown_file().and_then(OpenedFile::error)
    }

    /// Shows the scene that is `scenes` places farther; after the last comes the first.
    pub fn go_on(&mut self, scenes: isize) {
        let count = self.stage.scenes.len() + usize::from(self.file.is_some());
        let number = self.number as isize + scenes;
        self.number = number.rem_euclid(count as isize) as usize;
    }

    /// Shows the scene that shows picture files; false if the stage has none.
    pub fn show_picture_file(&mut self) -> bool {
        let mut scenes = self.stage.scenes.iter();
        let Some(number) = scenes.position(|scene| scene.uses.file) else {
            return false;
        };
        self.number = number + usize::from(self.file.is_some());
        true
    }
}
