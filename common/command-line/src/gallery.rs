//! `Gallery`: the scenes of a stage and of a scene file, of which a window shows one at a time.

mod answers;
mod camera;
mod renderer;
mod rendering;
mod scenes;

use std::path::PathBuf;

use common::{Edits, Error, Scene, Settings, Size};

use self::answers::Answer;
use self::camera::MovedCamera;
use self::rendering::Rendering;
use crate::LivePicture;
use crate::black_picture::warn_if_black;
use crate::explained_pixel::ExplainedPixel;
use crate::options::Options;
use crate::print::warn;
use crate::render::{print_notes, warn_unused};
pub(crate) use scenes::Scenes;

/// The scenes, the picture of the one that is shown, and what a person wants to know of it.
pub struct Gallery<'a> {
    scenes: Scenes<'a>,
    options: Options,
    camera: MovedCamera,
    rendering: Rendering,
    explained: Option<ExplainedPixel>,
    /// The answer to the last key.
    answer: Answer,
    /// What is wrong with the finished picture; empty if nothing is.
    warning: String,
}

impl<'a> Gallery<'a> {
    pub(crate) fn new(scenes: Scenes<'a>, options: &Options) -> Result<Self, Error> {
        let (mut size, mut transfer) = (Size::COURSE, options.transfer);
        if let Some(scene) = scenes.shown() {
            let settings = options.settings(scene)?;
            (size, transfer) = (settings.size, settings.transfer);
        }
        Ok(Self {
            scenes,
            options: options.clone(),
            camera: MovedCamera::default(),
            rendering: Rendering::new(LivePicture::new(size, transfer)),
            explained: None,
            answer: Answer::none(),
            warning: String::new(),
        })
    }

    /// The scene that is shown; none if its file was never right.
    fn scene(&self) -> Option<&Scene> {
        self.scenes.shown()
    }

    /// The picture as far as it is known.
    #[must_use]
    pub fn picture(&self) -> &LivePicture {
        &self.rendering.picture
    }

    /// Whether the picture is being rendered.
    #[must_use]
    pub const fn is_rendering(&self) -> bool {
        self.rendering.is_running()
    }

    /// The pixel that is explained, with its rays.
    #[must_use]
    pub const fn explained(&self) -> Option<&ExplainedPixel> {
        self.explained.as_ref()
    }

    /// Whether the scene shows a picture file, and the command line names none.
    #[must_use]
    pub fn asks_for_file(&self) -> bool {
        let uses_file = self.scene().is_some_and(|scene| scene.uses.file);
        uses_file && self.options.open.is_none()
    }

    /// Whether a scene of the stage shows picture files.
    #[must_use]
    pub fn opens_pictures(&self) -> bool {
        let mut scenes = self.scenes.stage.scenes.iter();
        scenes.any(|scene| scene.uses.file)
    }

    fn settings(&self, scene: &Scene) -> Result<Settings, Error> {
        Ok(Settings {
            edits: self.camera.edits,
            ..self.options.settings(scene)?
        })
    }

    /// Reads a picture file, whose size is not known before. An error if it cannot be opened.
    pub fn read_picture_file(&mut self) -> Result<(), Error> {
        if self.scene().is_none_or(|scene| !scene.uses.file) {
            return Ok(());
        }
        self.start()?;
        self.wait();
        self.rendering.take_error().map_or(Ok(()), Err)
    }

    /// Prints the notes on the first scene, and starts to render it.
    pub fn begin(&mut self) -> Result<(), Error> {
        if let Some(error) = self.error() {
            warn(&format!("error: {error}"));
            warn("note: --watch waits until the file is corrected");
        } else if let Some(scene) = self.scene() {
            warn_unused(scene, &self.options, &self.settings(scene)?);
        }
        if self.rendering.is_idle() {
            self.start()?;
        }
        Ok(())
    }

    /// Starts to render the scene. An earlier rendering stops. A scene file that was never right has nothing
    /// to render.
    fn start(&mut self) -> Result<(), Error> {
        (self.explained, self.camera.has_moved) = (None, false);
        self.answer = Answer::none();
        self.warning.clear();
        let Some(scene) = self.scene().cloned() else {
            self.rendering.stop();
            return Ok(());
        };
        let settings = self.settings(&scene)?;
        self.rendering.start(scene, settings, &self.options)
    }

    fn start_or_fail(&mut self) {
        if let Err(error) = self.start() {
            self.rendering.fail(error);
        }
    }

    /// Reads a watched file that has been saved, renders the scene anew if its camera has moved, and takes a
    /// finished picture. True if the window has to show something new.
    pub fn update(&mut self) -> bool {
        let is_read = self.reread_file();
        // A camera that moves on and on is seen at each place.
        let shows_something = self.picture().changes() > 0 || !self.is_rendering();
        if self.camera.has_moved && shows_something {
            self.start_or_fail();
        }
        let has_ended = self.rendering.has_ended();
        if has_ended {
            self.wait();
        }
        is_read || has_ended
    }

    /// A broken file leaves the picture as it is; its error goes to the terminal, too.
    fn reread_file(&mut self) -> bool {
        let Some(file) = &mut self.scenes.file else {
            return false;
        };
        if !file.reread(self.scenes.stage) {
            return false;
        }
        if let Some(error) = file.error() {
            warn(&format!("error: {error}"));
            return true;
        }
        file.scene().into_iter().for_each(print_notes);
        if self.scenes.shown_file().is_some() {
            self.start_or_fail();
        }
        true
    }

    /// Waits for the end of the rendering.
    pub fn wait(&mut self) {
        if !self.rendering.wait() {
            return;
        }
        self.answer = Answer::none();
        let Some(image) = self.rendering.image() else {
            return;
        };
        // A camera that was moved by hand may look away.
        if self.camera.edits == Edits::default()
            && let Some(scene) = self.scene()
            && let Ok(settings) = self.settings(scene)
        {
            warn_if_black(scene, &settings, image);
        }
        let bad = image.count_non_finite();
        if bad > 0 {
            self.warning = format!("warning: {bad} pixels are no finite numbers");
        }
    }

    /// Shows the scene that is `scenes` places farther in the list; after the last comes the first.
    pub fn go_on(&mut self, scenes: isize) {
        self.scenes.go_on(scenes);
        self.reset();
    }

    /// Shows a picture file.
    pub fn open(&mut self, path: PathBuf) {
        if self.scenes.show_picture_file() {
            self.options.open = Some(path);
            self.reset();
        }
    }
}

#[cfg(test)]
mod tests;
