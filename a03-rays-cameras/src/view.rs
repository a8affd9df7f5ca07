//! `View`: a camera and the world before it, which every renderer takes; the choice of the
//! renderer; and `TracedScene`, the scene that a view belongs to.

use std::any::Any;
use std::sync::Arc;

use common::{ArgumentError, Color, Error, Image, Progress, Renderer, Scene, Settings, Size};

use crate::{Camera, Ray, render};

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
    #[cfg(not(handout))]
    fn for_engine(&self, _depth: u32) -> Option<engine::Scene<'_>> {
        None
    }

    /// The places of the lights that have one, so that they can be moved.
    #[cfg(not(handout))]
    fn light_places(&mut self) -> Vec<&mut a02_math::Point3> {
        Vec::new()
    }

    /// The same world with wrappers around its parts, which count its work and record its steps;
    /// with `all_work` they also do the work that the lesson leaves out. The colours do not
    /// change.
    #[cfg(not(handout))]
    fn watched(self: Box<Self>, all_work: bool) -> Box<dyn TracedWorld>;
}

/// A world given by the light along each ray, for a background or a formula of its own.
impl<F: Fn(&Ray) -> Color + Send + Sync + 'static> TracedWorld for F {
    fn radiance(&self, ray: &Ray, _: u32) -> Color {
        self(ray)
    }

    #[cfg(not(handout))]
    fn watched(self: Box<Self>, _: bool) -> Box<dyn TracedWorld> {
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

/// Renders a picture, as [`render`], for code that is not in the lesson.
#[cfg(handout)]
pub fn paint(
    camera: &dyn Camera,
    radiance: &(dyn Fn(&Ray) -> Color + Sync),
    settings: &Settings,
) -> Result<Image, Error> {
    render(camera, radiance, settings, &())
}

impl View {
    /// Renders the picture with the lesson, the only renderer here.
    #[cfg(handout)]
    pub fn render(self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
        if settings.renderer != Renderer::Lesson || settings.max_error.is_some() {
            let flags = "this workbook has no --fast, --no-omit and --max-error";
            return Err(Error::Usage(flags.to_owned()));
        }
        let radiance = |ray: &Ray| self.world.radiance(ray, settings.depth);
        render(&self.camera, radiance, settings, progress)
    }

    /// Renders the picture with the renderer of the settings.
    #[cfg(not(handout))]
    pub fn render(self, settings: &Settings, progress: &dyn Progress) -> Result<Image, Error> {
        if settings.renderer == Renderer::Engine
            && let Some(scene) = self.world.for_engine(settings.depth)
        {
            return crate::fast::render(scene, &*self.camera, settings, progress);
        }
        let bounds = settings.max_error.map(|max_error| {
            let scene = self.world.for_engine(settings.depth);
            let max_radiance = scene.map_or(f64::INFINITY, |scene| scene.max_radiance());
            (max_error, max_radiance)
        });
        let Self { camera, world } = match settings.renderer {
            Renderer::AllWork => self.watched(settings, true),
            Renderer::Lesson if common::tally::is_on() => self.watched(settings, false),
            Renderer::Lesson | Renderer::Engine => self,
        };
        let radiance = |ray: &Ray| world.radiance(ray, settings.depth);
        let Some((max_error, max_radiance)) = bounds else {
            return render(&camera, radiance, settings, progress);
        };
        let light = |x, y| radiance(&camera.ray_for(settings.size, x, y));
        engine::adaptive::render_image(max_error, max_radiance, &light, settings, progress)
    }

    /// The scene as text in a language, `toml` or `povray`.
    #[cfg(not(handout))]
    pub(crate) fn export(&self, language: &str, settings: &Settings) -> Result<String, Error> {
        use scene_file::{POV_RAY, TOML, export};
        let scene = self.world.for_engine(settings.depth);
        let phrases = if language == "povray" { POV_RAY } else { TOML };
        let camera = crate::fast::camera(&*self.camera);
        let text = scene.map(|scene| export(phrases, &scene, &camera, settings));
        let text = text.unwrap_or_else(|| Err("its world is a formula, without shapes".to_owned()));
        text.map_err(|reason| Error::Usage(format!("this scene cannot be written: {reason}")))
    }

    /// The view with wrappers that count its work and record its steps.
    #[cfg(not(handout))]
    pub(crate) fn watched(self, settings: &Settings, all_work: bool) -> Self {
        Self {
            camera: crate::instruments::watched::camera(self.camera, settings, all_work),
            world: self.world.watched(all_work),
        }
    }
}

/// A scene whose picture is traced: its names, and its camera and world as a value.
#[derive(Clone, Debug)]
pub struct TracedScene {
    /// The name on the command line, in kebab case.
    pub name: &'static str,
    /// A description of the picture, in one line.
    pub about: &'static str,
    /// Camera and world for a picture of this size.
    pub view: fn(Size) -> Result<View, ArgumentError>,
    /// Whether surfaces reflect rays, so that the depth changes the picture.
    pub reflects: bool,
    /// The settings where the command line has no others.
    pub defaults: Settings,
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
            view,
            reflects: false,
            defaults: Settings::default(),
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
}

/// The scene for the program of the stage.
impl From<TracedScene> for Scene {
    fn from(row: TracedScene) -> Self {
        let view = move |size| Ok((row.view)(size)?);
        scene_of(row.name, row.about, row.reflects, view).with_defaults(row.defaults)
    }
}

/// A scene for the program, whose surfaces may reflect rays.
pub(crate) fn scene_of<F>(name: &'static str, about: &'static str, reflects: bool, view: F) -> Scene
where
    F: Fn(Size) -> Result<View, Error> + Send + Sync + 'static,
{
    let make = Arc::new(view);
    let made = Arc::clone(&make);
    let mut scene = Scene::traced(name, about, move |settings, progress| {
        let view = made(settings.size)?;
        #[cfg(not(handout))]
        let view = view.moved(settings, &*made)?;
        view.render(settings, progress)
    });
    scene.uses.depth = reflects;
    scene.explained = Some(Arc::new(crate::instruments::ViewOf(name, make)));
    scene
}
