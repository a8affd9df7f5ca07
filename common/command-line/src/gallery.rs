//! `Gallery`: the scenes of a stage and of a scene file, of which a window shows one at a time.

mod answers;
mod camera;
mod renderer;

use std::mem;
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::{self, JoinHandle};
use std::time::Instant;

use common::{Edits, Error, Image, Scene, Settings, Size, Stage};

use crate::LivePicture;
use crate::black_picture::warn_if_black;
use crate::explained_pixel::ExplainedPixel;
use crate::grammar::Showing;
use crate::opened_file::OpenedFile;
use crate::options::Options;
use crate::print::warn;
use crate::render::{print_notes, warn_unused};

/// The scenes, the picture of the one that is shown, and what a person wants to know of it.
pub struct Gallery<'a> {
    stage: &'a Stage,
    /// The scene file, which stands before the scenes of the stage.
    file: Option<OpenedFile>,
    /// The number of the scene that is shown.
    number: usize,
    options: Options,
    /// The way of the camera from its place in the scene.
    edits: Edits,
    /// Whether the camera has moved since the rendering began.
    has_moved: bool,
    picture: Arc<LivePicture>,
    job: Job,
    explained: Option<ExplainedPixel>,
    /// The answer to the last key; empty if there is none.
    message: String,
    /// When it was given.
    answered: Instant,
    /// What is wrong with the finished picture; empty if nothing is.
    warning: String,
}

/// The rendering of the picture.
enum Job {
    /// There is nothing to render.
    Idle,
    /// A thread renders.
    Running(JoinHandle<Result<Image, Error>>),
    /// The finished picture, or the reason for its absence.
    Done(Result<Image, Error>),
}

impl<'a> Gallery<'a> {
    pub(crate) fn new(
        stage: &'a Stage,
        file: Option<OpenedFile>,
        number: usize,
        showing: &Showing,
    ) -> Result<Self, Error> {
        let options = showing.options.clone();
        let mut gallery = Self {
            stage,
            file,
            number,
            edits: Edits::default(),
            has_moved: false,
            picture: Arc::new(LivePicture::new(Size::COURSE, options.transfer)),
            options,
            job: Job::Idle,
            explained: None,
            message: String::new(),
            answered: Instant::now(),
            warning: String::new(),
        };
        if let Some(scene) = gallery.scene() {
            let settings = gallery.settings(scene)?;
            let picture = LivePicture::new(settings.size, settings.transfer);
            gallery.picture = Arc::new(picture);
        }
        Ok(gallery)
    }

    /// The scene that is shown; none if its file was never right.
    fn scene(&self) -> Option<&Scene> {
        match (&self.file, self.number) {
            (Some(file), 0) => file.scene(),
            (Some(_), number) => self.stage.scenes.get(number - 1),
            (None, number) => self.stage.scenes.get(number),
        }
    }

    /// The picture as far as it is known.
    #[must_use]
    pub fn picture(&self) -> &LivePicture {
        &self.picture
    }

    /// Whether the picture is being rendered.
    #[must_use]
    pub const fn is_rendering(&self) -> bool {
        matches!(self.job, Job::Running(_))
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
        self.stage.scenes.iter().any(|scene| scene.uses.file)
    }

    fn settings(&self, scene: &Scene) -> Result<Settings, Error> {
        Ok(Settings {
            edits: self.edits,
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
        match mem::replace(&mut self.job, Job::Idle) {
            Job::Done(Err(error)) => Err(error),
            job => {
                self.job = job;
                Ok(())
            }
        }
    }

    /// Prints the notes on the first scene, and starts to render it.
    pub fn begin(&mut self) -> Result<(), Error> {
        if let Some(error) = self.error() {
            warn(&format!("error: {error}"));
            warn("note: --watch waits until the file is corrected");
        } else if let Some(scene) = self.scene() {
            warn_unused(scene, &self.options, &self.settings(scene)?);
        }
        match self.job {
            Job::Idle => self.start(),
            _ => Ok(()),
        }
    }

    /// Starts to render the scene in a thread of its own. An earlier rendering stops. A scene file
    /// that was never right has nothing to render.
    fn start(&mut self) -> Result<(), Error> {
        self.picture.stop();
        self.job = Job::Idle;
        (self.explained, self.has_moved) = (None, false);
        self.message.clear();
        self.warning.clear();
        let Some(scene) = self.scene().cloned() else {
            return Ok(());
        };
        let settings = self.settings(&scene)?;
        let threads = self.options.thread_pool()?;
        // The window answers keys while all processors render.
        #[cfg(target_os = "linux")]
        threads.broadcast(|_| rustix::process::nice(10));
        let picture = Arc::new(LivePicture::new(settings.size, settings.transfer));
        picture.begin_with(&self.picture);
        self.picture = Arc::clone(&picture);
        // The pixels of a large picture take long to pack, too.
        let render = move || {
            let image = threads.install(|| picture.render(&scene, &settings))?;
            picture.finish(&image);
            Ok(image)
        };
        self.job = Job::Running(thread::spawn(render));
        Ok(())
    }

    fn start_or_fail(&mut self) {
        if let Err(error) = self.start() {
            self.job = Job::Done(Err(error));
        }
    }

    /// Reads a watched file that has been saved, renders the scene anew if its camera has moved, and takes a
    /// finished picture. True if the window has to show something new.
    pub fn update(&mut self) -> bool {
        let is_read = self.reread_file();
        // A camera that moves on and on is seen at each place.
        let shows_something = self.picture.changes() > 0 || !self.is_rendering();
        if self.has_moved && shows_something {
            self.start_or_fail();
        }
        let is_finished = match &self.job {
            Job::Running(thread) => thread.is_finished(),
            _ => false,
        };
        if is_finished {
            self.wait();
        }
        is_read || is_finished
    }

    /// A broken file leaves the picture as it is; its error goes to the terminal, too.
    fn reread_file(&mut self) -> bool {
        let Some(file) = &mut self.file else {
            return false;
        };
        if !file.reread(self.stage) {
            return false;
        }
        if let Some(error) = file.error() {
            warn(&format!("error: {error}"));
            return true;
        }
        file.scene().into_iter().for_each(print_notes);
        if self.number == 0 {
            self.start_or_fail();
        }
        true
    }

    /// Waits for the end of the rendering.
    pub fn wait(&mut self) {
        let thread = match mem::replace(&mut self.job, Job::Idle) {
            Job::Running(thread) => thread,
            job => {
                self.job = job;
                return;
            }
        };
        self.message.clear();
        let outcome = thread.join();
        let outcome = outcome.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        if let Ok(image) = &outcome {
            if self.picture.size() != image.size() {
                // The size of a file is not known before.
                let mut picture = LivePicture::new(image.size(), self.options.transfer);
                picture.began = self.picture.began;
                picture.finish(image);
                self.picture = Arc::new(picture);
            }
            // A camera that was moved by hand may look away.
            if self.edits == Edits::default()
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
        self.job = Job::Done(outcome);
    }

    /// Shows the scene that is `scenes` places farther in the list; after the last comes the first.
    pub fn go_on(&mut self, scenes: isize) {
        let count = self.stage.scenes.len() + usize::from(self.file.is_some());
        let number = self.number as isize + scenes;
        self.number = number.rem_euclid(count as isize) as usize;
        self.reset();
    }

    /// Shows a picture file.
    pub fn open(&mut self, path: PathBuf) {
        let scenes = &self.stage.scenes;
        if let Some(number) = scenes.iter().position(|scene| scene.uses.file) {
            self.options.open = Some(path);
            self.number = number + usize::from(self.file.is_some());
            self.reset();
        }
    }
}

/// A window that is closed ends the rendering.
impl Drop for Gallery<'_> {
    fn drop(&mut self) {
        self.picture.stop();
    }
}

#[cfg(test)]
mod tests;
