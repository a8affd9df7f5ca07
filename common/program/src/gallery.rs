//! `Gallery`: the scenes of a stage and of scene files, which a window shows one at a time.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::{Scope, ScopedJoinHandle};

use common::sensitivity::Influence;
use common::{Error, Image, Picture, Renderer, Scene, Settings, Size, Stage, UsedSettings, text};

use crate::appearance::Appearance;
use crate::grammar::Showing;
use crate::live_picture::{Coarse, coarse};
use crate::opened_file::OpenedFile;
use crate::options::Options;
use crate::pixel_panel::{PixelPanel, StopFlag, strongest};
use crate::print::warn;
use crate::render::{SLOW, print_notes};
use crate::save::save_beside_others;
use crate::target::make_default_folder;
use crate::{LivePicture, Slider};

/// A list of scenes, first those of scene files and then the stage's; the one that is being shown,
/// its rendering, and an explained pixel.
pub struct Gallery<'scope, 'a> {
    /// The stage.
    pub stage: &'scope Stage,
    /// The scene files, which stand before the scenes of the stage.
    files: Vec<OpenedFile>,
    /// Whether scene files are read again when they are saved.
    watches: bool,
    /// The number of the scene that is shown.
    number: usize,
    /// The flags of the command line.
    pub options: Options,
    /// How the window looks.
    pub appearance: Appearance,
    /// The sliders of the scene.
    pub sliders: Vec<Slider>,
    /// The way of the mouse that rotates the camera, to the right and down.
    rotated: [i32; 2],
    renderer: Option<Renderer>,
    /// Whether a number of the scene has changed since the rendering began.
    is_changed: bool,
    /// The picture as far as it is known; none before the file of a scene has been read.
    pub picture: Option<Arc<LivePicture>>,
    /// The finished picture, or the reason for its absence; none while it is rendered.
    pub outcome: Option<Result<Image, Error>>,
    /// The pixel that is explained.
    pub pixel: Option<[u32; 2]>,
    /// The numbers behind the pixel, as soon as they are known.
    pub explanation: Option<Result<PixelPanel, Error>>,
    /// How the pixel changes with the numbers of its scene file, the strongest first, as soon as it
    /// is known; none for a scene of the stage.
    pub influences: Option<Result<Vec<Influence>, Error>>,
    scope: &'scope Scope<'scope, 'a>,
    rendering: Option<Task<'scope, Image>>,
    explaining: Option<Task<'scope, PixelPanel>>,
    measuring: Option<Measuring<'scope>>,
}

/// A task in a thread of its own.
type Task<'scope, T> = ScopedJoinHandle<'scope, Result<T, Error>>;

/// The thread that looks for the strongest numbers, and the flag that stops it.
struct Measuring<'scope> {
    /// None once its result has been taken.
    task: Option<Task<'scope, Vec<Influence>>>,
    stop: Arc<StopFlag>,
}

impl Drop for Measuring<'_> {
    fn drop(&mut self) {
        self.stop.set();
    }
}

/// The angle by which the camera rotates for a pixel of the mouse's way, in radians.
const ANGLE: f64 = 0.01;

impl<'scope, 'a> Gallery<'scope, 'a> {
    pub(crate) fn new(
        stage: &'scope Stage,
        files: Vec<OpenedFile>,
        number: usize,
        showing: &Showing,
        scope: &'scope Scope<'scope, 'a>,
    ) -> Self {
        Self {
            stage,
            files,
            watches: showing.watch,
            number,
            options: showing.options.clone(),
            appearance: showing.appearance,
            sliders: Vec::new(),
            rotated: [0; 2],
            renderer: None,
            is_changed: false,
            picture: None,
            outcome: None,
            pixel: None,
            explanation: None,
            influences: None,
            scope,
            rendering: None,
            explaining: None,
            measuring: None,
        }
    }

    /// The scene that is shown; none if its file was never right.
    #[must_use]
    pub fn scene(&self) -> Option<&Scene> {
        match self.files.get(self.number) {
            Some(file) => file.scene(),
            None => self.stage.scenes.get(self.number - self.files.len()),
        }
    }

    /// The settings that change the picture of the scene.
    #[must_use]
    pub fn uses(&self) -> UsedSettings {
        self.scene().map(|scene| scene.uses).unwrap_or_default()
    }

    /// The names of the scenes, in the order of their numbers: files have the names of the file.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let files = self.files.iter().map(|file| {
            let name = file.path().file_name().unwrap_or_default();
            text::visible(&name.to_string_lossy())
        });
        let scenes = self.stage.scenes.iter().map(|scene| scene.name.to_owned());
        files.chain(scenes).collect()
    }

    /// The name of the scene that is shown.
    #[must_use]
    pub fn name(&self) -> String {
        self.names().swap_remove(self.number)
    }

    /// The number of the scene that is shown.
    #[must_use]
    pub const fn number(&self) -> usize {
        self.number
    }

    /// Why there is no picture, or why it is not that of the file as it is now.
    #[must_use]
    pub fn error(&self) -> Option<&Error> {
        let file = self.files.get(self.number).and_then(OpenedFile::error);
        let picture = self.outcome.as_ref().and_then(|it| it.as_ref().err());
        file.or(picture)
    }

    /// Whether a scene file is watched, so that [`Self::update`] must be called without any input,
    /// too.
    #[must_use]
    pub fn watches(&self) -> bool {
        self.files.iter().any(OpenedFile::is_watched)
    }

    /// Whether the picture is being rendered.
    #[must_use]
    pub const fn is_rendering(&self) -> bool {
        self.rendering.is_some()
    }

    /// Whether the picture takes long, and the engine would draw the same sooner.
    #[must_use]
    pub fn is_slow(&self) -> bool {
        let elapsed = self
            .picture
            .as_ref()
            .map(|picture| picture.started.elapsed());
        self.is_rendering()
            && elapsed.is_some_and(|elapsed| elapsed > SLOW)
            && self.uses().sampling
            && self.renderer() == Renderer::Lesson
    }

    /// Whether threads are at work, or begin with the next call of [`Self::update`].
    #[must_use]
    pub const fn is_busy(&self) -> bool {
        let explains = self.explaining.is_some() || self.measuring.is_some();
        self.rendering.is_some() || explains || self.is_changed
    }

    /// Reads the watched scene files that have been saved, and starts to render the one that is
    /// shown. A broken file leaves the picture as it is; its error goes to the terminal, too.
    fn reread_files(&mut self) {
        for number in 0..self.files.len() {
            let file = &mut self.files[number];
            if !file.reread(self.stage) {
                continue;
            }
            if let Some(error) = file.error() {
                warn(&format!("error: {error}"));
                continue;
            }
            file.scene().into_iter().for_each(print_notes);
            if number == self.number {
                self.sliders.clear();
                self.start_or_fail();
            }
        }
    }

    /// Whether the stage opens scene files or pictures.
    #[must_use]
    pub fn opens_files(&self) -> bool {
        let mut scenes = self.stage.scenes.iter();
        self.stage.open.is_some() || scenes.any(|scene| scene.uses.file)
    }

    /// Opens a file, and shows its scene: a scene file, or a picture in a stage that shows pictures.
    pub fn open(&mut self, path: &Path) -> Result<(), Error> {
        let name = path.to_string_lossy();
        if OpenedFile::is_named(self.stage, &name) {
            let file = OpenedFile::open(self.stage, path, self.watches);
            // A broken file is waited for, and a wrong name is not.
            if file.scene().is_none() && !(self.watches && path.is_file()) {
                return file.into_scene().map(|_| ());
            }
            file.scene().into_iter().for_each(print_notes);
            let known = self.files.iter().position(|file| file.path() == path);
            let number = known.unwrap_or(self.files.len());
            match self.files.get_mut(number) {
                Some(known) => *known = file,
                None => self.files.push(file),
            }
            self.go_to(number);
            return Ok(());
        }
        let scenes = &self.stage.scenes;
        let Some(number) = scenes.iter().position(|scene| scene.uses.file) else {
            return self.stage.scene(&name).map(|_| ());
        };
        self.options.open = Some(path.to_owned());
        self.go_to(self.files.len() + number);
        Ok(())
    }

    /// Stage and scene, for the title of the window.
    #[must_use]
    pub fn title(&self) -> String {
        format!("{}: {}", self.stage.name, self.name())
    }

    /// The size of the picture; the course's before it is known.
    #[must_use]
    pub fn size(&self) -> Size {
        self.picture
            .as_ref()
            .map_or(Size::COURSE, |picture| picture.size())
    }

    /// Shows the scene of this number.
    pub fn go_to(&mut self, number: usize) {
        self.number = number.min(self.files.len() + self.stage.scenes.len() - 1);
        (self.picture, self.pixel) = (None, None);
        self.reset();
    }

    /// Moves a slider to one of its values.
    pub fn slide(&mut self, slider: usize, to: usize) {
        if let Some(slider) = self.sliders.get_mut(slider) {
            let to = to.min(slider.last());
            self.is_changed |= std::mem::replace(&mut slider.at, to) != to;
        }
    }

    /// Rotates the camera around the middle of the scene, by a way of the mouse.
    pub fn rotate(&mut self, way: [i32; 2]) {
        self.rotated = [self.rotated[0] - way[0], self.rotated[1] - way[1]];
        self.is_changed |= self.scene().is_some_and(|scene| scene.rays().is_ok());
    }

    /// The chosen renderer.
    #[must_use]
    pub fn renderer(&self) -> Renderer {
        let settings = self.scene().map(|scene| self.settings(scene));
        match settings {
            Some(Ok(settings)) => settings.renderer,
            _ => Renderer::Lesson,
        }
    }

    /// Chooses a renderer.
    pub fn render_with(&mut self, renderer: Renderer) {
        self.renderer = Some(renderer);
        self.is_changed = true;
    }

    /// Returns camera, lights and sliders to their places at the start.
    pub fn reset(&mut self) {
        self.rotated = [0; 2];
        self.sliders.clear();
        self.start_or_fail();
    }

    fn settings(&self, scene: &Scene) -> Result<Settings, Error> {
        let mut settings = self.options.settings(scene)?;
        settings.renderer = self.renderer.unwrap_or(settings.renderer);
        for slider in self
            .sliders
            .iter()
            .filter(|slider| slider.at != slider.start)
        {
            slider.apply(&mut settings);
        }
        settings.edits.orbit = self.rotated.map(|way| ANGLE * f64::from(way));
        Ok(settings)
    }

    /// Starts to render the scene in a separate thread. An earlier rendering stops. A scene file
    /// that was never right has nothing to render.
    pub fn start(&mut self) -> Result<(), Error> {
        self.stop();
        let Some(scene) = self.scene().cloned() else {
            return Ok(());
        };
        let settings = self.settings(&scene)?;
        if self.sliders.is_empty() {
            self.sliders = Slider::all(&scene, &settings)?;
        }
        let threads = self.options.thread_pool()?;
        // The window answers keys while all processors render.
        #[cfg(target_os = "linux")]
        threads.broadcast(|_| rustix::process::nice(10));
        let picture = Arc::new(LivePicture::new(settings.size, self.options.transfer));
        if let Some(earlier) = self.picture.take() {
            picture.begin_with(&earlier);
        }
        self.picture = Some(Arc::clone(&picture));
        let render = move || {
            for (side, settings) in coarse(&scene, &settings) {
                // The last rendering reports an error.
                let _ = scene.render(&settings, &Coarse(&picture, side));
            }
            scene.render(&settings, &*picture)
        };
        self.rendering = Some(self.scope.spawn(move || threads.install(render)));
        Ok(())
    }

    fn start_or_fail(&mut self) {
        if let Err(error) = self.start() {
            self.outcome = Some(Err(error));
        }
    }

    fn stop(&mut self) {
        if let Some(picture) = &self.picture {
            picture.stop();
        }
        (self.is_changed, self.rendering, self.explaining) = (false, None, None);
        (self.outcome, self.explanation) = (None, None);
        (self.influences, self.measuring) = (None, None);
    }

    /// Reads watched files that have been saved, takes the results of threads that have ended, and
    /// renders a changed scene anew, once the rendering before has shown something. True if the
    /// picture has just been finished.
    pub fn update(&mut self) -> bool {
        self.reread_files();
        let shows = |picture: &Arc<LivePicture>| picture.changes() > 0;
        if self.is_changed && self.picture.as_ref().is_none_or(shows) {
            self.start_or_fail();
        }
        if self.explaining.is_none() && self.explanation.is_none() {
            self.explain(self.pixel);
        }
        if let Some(task) = self.explaining.take_if(|task| task.is_finished()) {
            self.explanation = Some(result(task));
        }
        self.update_influences();
        let finished = self
            .rendering
            .as_ref()
            .is_some_and(ScopedJoinHandle::is_finished);
        if finished {
            self.wait();
        }
        finished
    }

    /// Waits for the end of the rendering.
    pub fn wait(&mut self) {
        let Some(outcome) = self.rendering.take().map(result) else {
            return;
        };
        if let Ok(image) = &outcome {
            // The size of a file is not known before.
            let (size, transfer) = (image.size(), self.options.transfer);
            let same = self.picture.take_if(|picture| picture.size() == size);
            let picture = same.unwrap_or_else(|| Arc::new(LivePicture::new(size, transfer)));
            picture.finish(image);
            self.picture = Some(picture);
        }
        self.outcome = Some(outcome);
    }

    /// Chooses the pixel that is explained.
    pub fn explain(&mut self, pixel: Option<[u32; 2]>) {
        (self.pixel, self.explanation, self.explaining) = (pixel, None, None);
        (self.influences, self.measuring) = (None, None);
        let (Some(pixel), Some(scene)) = (pixel, self.scene()) else {
            return;
        };
        let (Picture::Traced(traced), Ok(settings)) = (scene.picture.clone(), self.settings(scene))
        else {
            return;
        };
        let explain = move || PixelPanel::new(&*traced, settings, pixel);
        self.explaining = Some(self.scope.spawn(explain));
    }

    /// Whether the strongest numbers of the pixel are being looked for.
    #[must_use]
    pub const fn is_measuring(&self) -> bool {
        self.measuring.is_some()
    }

    /// Takes the influences on the pixel if they are known, or begins to look for them. That waits
    /// for the explanation and the picture, which are wanted first.
    fn update_influences(&mut self) {
        let is_finished = |measuring: &mut Measuring| {
            let task = measuring.task.as_ref();
            task.is_none_or(ScopedJoinHandle::is_finished)
        };
        if let Some(mut measuring) = self.measuring.take_if(is_finished) {
            self.influences = measuring.task.take().map(result);
        }
        let is_begun = self.influences.is_some() || self.measuring.is_some();
        let is_explained = matches!(self.explanation, Some(Ok(_)));
        if is_begun || !is_explained || self.rendering.is_some() {
            return;
        }
        let (Some(pixel), Some(scene)) = (self.pixel, self.scene()) else {
            return;
        };
        if scene.files.is_empty() {
            return;
        }
        let (Picture::Traced(traced), Ok(settings)) = (scene.picture.clone(), self.settings(scene))
        else {
            return;
        };
        let stop = Arc::new(StopFlag::default());
        let progress = Arc::clone(&stop);
        let measure = move || strongest(&*traced, settings, pixel, &*progress);
        self.measuring = Some(Measuring {
            task: Some(self.scope.spawn(measure)),
            stop,
        });
    }

    /// Saves a picture as `out/STAGE-SCENE.png` and returns its path. A different
    /// picture of this name is kept, and the new one gets a number.
    pub fn save(&self, image: &Image) -> Result<PathBuf, Error> {
        let folder = make_default_folder()?;
        let scene = self.scene().map_or("", |scene| scene.name);
        let name = format!("{}-{scene}", self.stage.name);
        let rgb = image.to_rgb8(self.options.transfer);
        save_beside_others(folder, &name, image.size(), &rgb)
    }
}

/// A window that is closed ends the rendering.
impl Drop for Gallery<'_, '_> {
    fn drop(&mut self) {
        self.stop();
    }
}

fn result<T>(task: Task<T>) -> Result<T, Error> {
    task.join()
        .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}

#[cfg(test)]
mod tests;
