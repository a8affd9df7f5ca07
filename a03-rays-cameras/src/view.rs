//! `View`: a camera and the world before it, which every renderer takes; the choice of the
//! renderer; and `TracedScene`, the scene that a view belongs to.

use std::any::Any;
use std::sync::Arc;

use common::sensitivity::{Footprint, NumberPlace};
use common::{
    ArgumentError, Color, Edits, Error, Image, Picture, PixelTrace, Progress, Renderer, Scene,
    SeenLine, Settings, Size, Traced, UsedSettings,
};

use crate::instruments::Instruments;
use crate::kinds::NumberedFile;
use crate::{Camera, Ray, instruments, kinds, render};

/// A camera and the world before it.
///
/// The functions of a stage's `scenes.rs` return the world in its own type. The renderers
/// take any [`TracedWorld`].
pub struct View<W = Box<dyn TracedWorld>> {
    /// The camera.
    pub camera: Box<dyn Camera>,
    /// The world.
    pub world: W,
}

/// A world that rays bring light from. Each stage implements it for its own type.
pub trait TracedWorld: Any + Send + Sync {
    /// The light that comes back along a ray that may hit `depth` surfaces in turn: the code
    /// of the lesson.
    fn radiance(&self, ray: &Ray, depth: u32) -> Color;

    /// The world in the numbers of the engine; none if the engine has no type for it.
    fn for_engine(&self, _depth: u32) -> Option<engine::Scene<'_>> {
        None
    }

    /// The shapes of the world as the values of their tables in a scene file, each with the
    /// number of its surface in the engine's scene.
    fn written_shapes(&self) -> Vec<scene_file::WrittenShape> {
        Vec::new()
    }

    /// The number of the object, from 1, that a ray hits first, and the `t` of this hit.
    fn nearest(&self, _ray: &Ray) -> Option<(usize, f64)> {
        None
    }

    /// The name of the object of a number.
    fn object_name(&self, _number: usize) -> String {
        String::new()
    }

    /// The same world with these instruments around its parts. The colours do not change.
    fn recorded(self: Box<Self>, instruments: Instruments) -> Box<dyn TracedWorld>;
}

/// A world given by the light along each ray, for a background or a formula of its own.
impl<F: Fn(&Ray) -> Color + Send + Sync + 'static> TracedWorld for F {
    fn radiance(&self, ray: &Ray, _: u32) -> Color {
        self(ray)
    }

    fn recorded(self: Box<Self>, _: Instruments) -> Box<dyn TracedWorld> {
        self
    }
}

impl<W> View<W> {
    /// A view of this world.
    pub fn new(camera: impl Camera, world: W) -> Self {
        Self {
            camera: Box::new(camera),
            world,
        }
    }

    /// The same camera before the world that this function makes of the world.
    pub fn map<V>(self, world: impl FnOnce(W) -> V) -> View<V> {
        View {
            camera: self.camera,
            world: world(self.world),
        }
    }
}

impl<W: TracedWorld> View<W> {
    /// The same view for the renderers.
    #[must_use]
    pub fn boxed(self) -> View {
        self.map(|world| Box::new(world) as _)
    }
}

impl View {
    /// Renders the picture with the renderer of the settings.
    pub fn render(self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
        let instruments = Instruments::of_settings(settings);
        if settings.renderer == Renderer::Engine
            && let Some(scene) = self.world.for_engine(settings.depth)
        {
            return kinds::render(scene, &*self.camera, settings, progress);
        }
        let bounds = settings.max_error.map(|max_error| {
            let scene = self.world.for_engine(settings.depth);
            let max_radiance = scene.map_or(f64::INFINITY, |scene| scene.max_radiance());
            (max_error, max_radiance)
        });
        let Self { camera, world } = match instruments {
            Some(instruments) => self.recorded(instruments),
            None => self,
        };
        let radiance = |ray: &Ray| world.radiance(ray, settings.depth);
        let Some((max_error, max_radiance)) = bounds else {
            return render(&camera, radiance, settings, progress);
        };
        let light = |x, y| radiance(&camera.ray_for(settings.size, x, y));
        engine::adaptive::render_image(max_error, max_radiance, &light, settings, progress)
    }

    /// The view with these instruments.
    pub(crate) fn recorded(self, instruments: Instruments) -> Self {
        Self {
            camera: instruments::recorded::camera(self.camera),
            world: self.world.recorded(instruments),
        }
    }
}

/// Camera and world for a picture with these settings.
pub type ViewOfSettings = dyn Fn(&Settings) -> Result<View, Error> + Send + Sync;

/// A scene whose picture is traced: its names, and its camera and world as a value.
#[derive(Clone)]
pub struct TracedScene {
    /// The name on the command line, in kebab case.
    pub name: &'static str,
    /// A description of the picture, in one line.
    pub about: &'static str,
    /// Camera and world for a picture with these settings.
    pub view: Arc<ViewOfSettings>,
    /// Whether surfaces reflect rays, so that the depth changes the picture.
    pub reflects: bool,
    /// The settings where the command line has no others.
    pub defaults: Settings,
    /// The scene file that it was read from.
    pub file: Option<Arc<NumberedFile>>,
}

impl TracedScene {
    /// A scene without mirrors, with the usual settings.
    pub fn new(
        name: &'static str,
        about: &'static str,
        view: fn(Size) -> Result<View, ArgumentError>,
    ) -> Self {
        Self {
            name,
            about,
            view: Arc::new(move |settings| Ok(view(settings.size)?)),
            reflects: false,
            defaults: Settings::default(),
            file: None,
        }
    }

    /// The same scene, with surfaces that reflect rays.
    #[must_use]
    pub fn reflecting(self) -> Self {
        Self {
            reflects: true,
            ..self
        }
    }

    /// Camera and world, with the camera where a person has moved it in the window.
    fn edited_view(&self, settings: &Settings) -> Result<View, Error> {
        let view = (self.view)(settings)?;
        if settings.edits == Edits::default() {
            return Ok(view);
        }
        Ok(view.edited(settings.size, &settings.edits))
    }
}

impl Traced for TracedScene {
    fn render(&self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
        self.edited_view(settings)?.render(settings, progress)
    }

    fn color(&self, settings: &Settings, pixel: [u32; 2]) -> Result<Color, Error> {
        Ok(self.edited_view(settings)?.color(settings, pixel))
    }

    fn trace(&self, settings: &Settings, pixel: [u32; 2]) -> Result<PixelTrace, Error> {
        Ok(self.edited_view(settings)?.trace(settings, pixel))
    }

    fn why_black(&self, settings: &Settings) -> Result<Option<String>, Error> {
        Ok(self.edited_view(settings)?.why_black(settings))
    }

    fn drawing(&self, settings: &Settings, trace: &PixelTrace) -> Result<String, Error> {
        let view = self.edited_view(settings)?;
        Ok(view.drawing(&trace.steps, self.name))
    }

    fn seen_rays(&self, settings: &Settings, trace: &PixelTrace) -> Result<Vec<SeenLine>, Error> {
        let view = self.edited_view(settings)?;
        Ok(view.seen_rays(settings.size, &trace.steps))
    }

    fn camera_lines(&self, settings: &Settings) -> Result<String, Error> {
        self.edited_view(settings)?.camera_lines(settings)
    }

    fn export(&self, language: &str, settings: &Settings) -> Result<String, Error> {
        self.edited_view(settings)?.export(language, settings)
    }

    fn numbers(&self, settings: &Settings) -> Result<Vec<NumberPlace>, Error> {
        let Some(file) = &self.file else {
            return Err(Error::Usage(format!(
                "{} is a scene of the program, whose numbers stand in its code; name a scene file, \
                 such as one that `export {} --to toml -o scene.toml` writes",
                self.name, self.name
            )));
        };
        Ok(file.numbers(settings))
    }

    fn with(
        &self,
        settings: &Settings,
        number: &NumberPlace,
        value: f64,
    ) -> Option<Box<dyn Traced>> {
        let known = Arc::clone(self.file.as_ref()?);
        let file = known.file.with(settings.transfer, number, value)?;
        Some(Box::new(Self {
            view: Arc::new(move |_| known.view_of(&file)),
            ..self.clone()
        }))
    }

    fn footprint(&self, settings: &Settings, pixel: Option<[u32; 2]>) -> Result<Footprint, Error> {
        Ok(self.edited_view(settings)?.footprint(settings.size, pixel))
    }
}

/// The scene for the program of the stage.
impl From<TracedScene> for Scene {
    fn from(scene: TracedScene) -> Self {
        Self {
            name: scene.name,
            about: scene.about,
            defaults: scene.defaults.clone(),
            uses: UsedSettings {
                size: true,
                sampling: true,
                depth: scene.reflects,
                file: false,
            },
            is_large: false,
            files: Vec::new(),
            notes: Vec::new(),
            picture: Picture::Traced(Arc::new(scene)),
        }
    }
}
