//! `Gallery`: the scenes of a stage, which a window shows one at a time.

use std::path::PathBuf;
use std::sync::Arc;
use std::thread::{Scope, ScopedJoinHandle};

use common::{Error, Image, Picture, Renderer, Scene, Settings, Size, Stage};

use crate::appearance::Appearance;
use crate::explanation::Explanation;
use crate::grammar::Showing;
use crate::live_picture::{Coarse, coarse};
use crate::options::Options;
use crate::print::warn;
use crate::render::print_notes;
use crate::save::save_beside_others;
use crate::target::make_default_folder;
use crate::watch::Watch;
use crate::{LivePicture, Slider};

/// The scenes of a stage, the one that is being shown, its rendering, and an explained pixel.
pub struct Gallery<'scope, 'a> {
    /// The stage.
    pub stage: &'scope Stage,
    /// The scene that is shown.
    pub scene: Scene,
    /// The files of the scene, if they are watched.
    watch: Option<Watch>,
    /// The flags of the command line.
    pub options: Options,
    /// How the window looks.
    pub appearance: Appearance,
    /// The sliders of the scene.
    pub sliders: Vec<Slider>,
    /// Way of the mouse that turns the camera, to the right and down.
    turned: [i32; 2],
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
    pub explanation: Option<Result<Explanation, Error>>,
    scope: &'scope Scope<'scope, 'a>,
    rendering: Option<Task<'scope, Image>>,
    explaining: Option<Task<'scope, Explanation>>,
}

/// A task in a thread of its own.
type Task<'scope, T> = ScopedJoinHandle<'scope, Result<T, Error>>;

/// The angle by which the camera turns for a pixel of the mouse's way, in radians.
const TURN: f64 = 0.01;

impl<'scope, 'a> Gallery<'scope, 'a> {
    pub(crate) fn new(
        stage: &'scope Stage,
        scene: Scene,
        watch: Option<Watch>,
        showing: &Showing,
        scope: &'scope Scope<'scope, 'a>,
    ) -> Self {
        Self {
            stage,
            scene,
            watch,
            options: showing.options.clone(),
            appearance: showing.appearance,
            sliders: Vec::new(),
            turned: [0; 2],
            renderer: None,
            is_changed: false,
            picture: None,
            outcome: None,
            pixel: None,
            explanation: None,
            scope,
            rendering: None,
            explaining: None,
        }
    }

    /// Opens the watched scene file if it has been saved, and starts to render it. A broken file
    /// leaves the picture as it is; its error goes to the terminal, too.
    pub fn reopen(&mut self) -> Result<(), Error> {
        let stage = self.stage;
        let Some(opened) = self.watch.as_mut().and_then(|watch| watch.reopen(stage)) else {
            return Ok(());
        };
        let started = opened.and_then(|scene| {
            self.options.settings(&scene)?;
            print_notes(&scene);
            self.scene = scene;
            self.sliders.clear();
            self.start()
        });
        started.inspect_err(|error| warn(&format!("error: {error}")))
    }

    /// Stage and scene, for the title of the window.
    #[must_use]
    pub fn title(&self) -> String {
        format!("{}: {}", self.stage.name, self.scene.name)
    }

    /// The size of the picture; the course's before it is known.
    #[must_use]
    pub fn size(&self) -> Size {
        self.picture
            .as_ref()
            .map_or(Size::COURSE, |picture| picture.size())
    }

    /// The number of the scene; the scene of a file counts as the first.
    #[must_use]
    pub fn number(&self) -> usize {
        let mut scenes = self.stage.scenes.iter();
        scenes
            .position(|scene| scene.name == self.scene.name)
            .unwrap_or(0)
    }

    /// Shows the scene of this number.
    pub fn go_to(&mut self, number: usize) {
        if let Some(scene) = self.stage.scenes.get(number) {
            self.scene = scene.clone();
        }
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

    /// Turns the camera around the middle of the scene, by a way of the mouse.
    pub fn turn(&mut self, way: [i32; 2]) {
        self.turned = [self.turned[0] - way[0], self.turned[1] - way[1]];
        self.is_changed |= self.scene.rays().is_ok();
    }

    /// The chosen renderer.
    #[must_use]
    pub fn renderer(&self) -> Renderer {
        self.settings()
            .map_or(Renderer::Lesson, |settings| settings.renderer)
    }

    /// Chooses a renderer.
    pub fn render_with(&mut self, renderer: Renderer) {
        self.renderer = Some(renderer);
        self.is_changed = true;
    }

    /// Returns camera, lights and sliders to their places at the start.
    pub fn reset(&mut self) {
        self.turned = [0; 2];
        self.sliders.clear();
        self.start_or_fail();
    }

    fn settings(&self) -> Result<Settings, Error> {
        let mut settings = self.options.settings(&self.scene)?;
        settings.renderer = self.renderer.unwrap_or(settings.renderer);
        for slider in self
            .sliders
            .iter()
            .filter(|slider| slider.at != slider.start)
        {
            slider.apply(&mut settings);
        }
        settings.edits.orbit = self.turned.map(|way| TURN * f64::from(way));
        Ok(settings)
    }

    /// Starts to render the scene in a separate thread. An earlier rendering stops.
    pub fn start(&mut self) -> Result<(), Error> {
        self.stop();
        let settings = self.settings()?;
        if self.sliders.is_empty() {
            self.sliders = Slider::all(&self.scene, &settings)?;
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
        let scene = self.scene.clone();
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
    }

    /// Takes the results of threads that have ended, and renders a changed scene anew, once the
    /// rendering before has shown something. True if the picture has just been finished.
    pub fn update(&mut self) -> bool {
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
        let (Some(pixel), Picture::Traced(traced), Ok(settings)) =
            (pixel, self.scene.picture.clone(), self.settings())
        else {
            return;
        };
        let explain = move || Explanation::new(&*traced, settings, pixel);
        self.explaining = Some(self.scope.spawn(explain));
    }

    /// Saves a picture as `out/STAGE-SCENE.png` and returns its path. A different
    /// picture of this name is kept, and the new one gets a number.
    pub fn save(&self, image: &Image) -> Result<PathBuf, Error> {
        let folder = make_default_folder()?;
        let name = format!("{}-{}", self.stage.name, self.scene.name);
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
