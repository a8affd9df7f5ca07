//! Whole scenes of any numbers. Each one that the constructors accept is rendered:
//! every pixel must be a finite number, and the same to the last bit by the lesson, by
//! the engine and with all work. Adaptive sampling must end with finite numbers, and cut
//! off only mirrored light below its threshold.

use std::any::Any;

use a03_rays_cameras::{Camera, Ray, View};
use a04_intersections::Geometry;
use a05_lighting::{DirectionalLight, Lambert, Light, Phong, PointLight, SingleColor, SpotLight};
use a06_shadows_reflection::{LightSource, Reflective, ShadowedWorld, Surface};
use a07_transforms::{Node, traced};
use arbitrary::{Result, Unstructured};
use common::{ArgumentError, Color, Image, Renderer, Sampling, Settings, Size};
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::number::{color, number, point, vector};
use crate::shapes::{accepted, camera, shape};

/// Renders the scene that the bytes make by all three renderers.
pub fn check(bytes: &[u8]) {
    let Ok(scene) = Scene::new(bytes) else {
        return;
    };
    let picture = scene.picture(Renderer::Lesson, None);
    scene.check_pixels(&picture, 0.0);
    for renderer in [Renderer::Engine, Renderer::AllWork] {
        scene.check_same(&scene.picture(renderer, None), &picture);
    }
    if let Some(max_error) = scene.max_error {
        for renderer in [Renderer::Lesson, Renderer::Engine] {
            // Light that was added to a pixel and taken off again is rounded.
            scene.check_pixels(&scene.picture(renderer, Some(max_error)), -1e-9);
        }
    }
    scene.check_cutoff();
}

struct Scene<'a> {
    bytes: &'a [u8],
    /// Without an error: all renderers make the same picture.
    settings: Settings,
    max_error: Option<f64>,
    /// Mirrored light below this may be cut off.
    cutoff: f64,
}

impl std::fmt::Debug for Scene<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let View { camera, world } = self.view();
        let size = self.settings.size;
        let (columns, rows) = (0..size.width(), 0..size.height());
        let places = rows.flat_map(|y| columns.clone().map(move |x| (x, y)));
        let rays = places.map(|(x, y)| camera.ray_for(size, x.into(), y.into()));
        let rays = rays.collect::<Vec<_>>();
        write!(f, "{:#?}\n{world:#?}\n{rays:#?}", self.settings)
    }
}

impl<'a> Scene<'a> {
    fn new(bytes: &'a [u8]) -> Result<Self> {
        let u = &mut Unstructured::new(bytes);
        let settings = settings(u)?;
        let scene = Self {
            bytes,
            max_error: settings.max_error,
            settings: Settings {
                max_error: None,
                ..settings
            },
            cutoff: f64::from(u.arbitrary::<u8>()?) / 512.0,
        };
        camera(u)?;
        world(u)?;
        Ok(scene)
    }

    /// The same bytes make the same view.
    fn view(&self) -> View<ShadowedWorld> {
        let made = || {
            let u = &mut Unstructured::new(self.bytes);
            settings(u)?;
            u.arbitrary::<u8>()?;
            let camera = camera(u)?;
            let world = world(u)?;
            Ok::<_, arbitrary::Error>(View { camera, world })
        };
        made().expect("it was made before")
    }

    fn picture(&self, renderer: Renderer, max_error: Option<f64>) -> Image {
        self.render(self.view(), renderer, max_error)
    }

    /// Renders on this thread: to wake another takes longer than so small a picture.
    fn render(
        &self,
        view: View<ShadowedWorld>,
        renderer: Renderer,
        max_error: Option<f64>,
    ) -> Image {
        thread_local! {
            static ALONE: ThreadPool = ThreadPoolBuilder::new()
                .num_threads(1)
                .use_current_thread()
                .build()
                .expect("a pool of this thread");
        }
        let settings = Settings {
            renderer,
            max_error,
            ..self.settings.clone()
        };
        let render = || traced(view).render(&settings, &());
        ALONE.with(|pool| pool.install(render)).expect("a picture")
    }

    fn check_pixels(&self, picture: &Image, least: f64) {
        for pixel in picture.pixels() {
            let holds = |channel: f64| channel.is_finite() && channel >= least;
            let channels = pixel.channels();
            assert!(channels.into_iter().all(holds), "{pixel:?}: {self:?}");
        }
    }

    fn check_same(&self, picture: &Image, expected: &Image) {
        for (pixel, expected) in picture.pixels().iter().zip(expected.pixels()) {
            let [bits, expected_bits] = [pixel, expected].map(|c| c.channels().map(f64::to_bits));
            assert_eq!(bits, expected_bits, "{pixel:?}, {expected:?}: {self:?}");
        }
    }

    /// Compares the engine with and without an allowed error, where all rays of a pixel are the
    /// same, so that only the cutoff of reflections differs. Bound: the threshold, and the
    /// rounding of the sums over surfaces, lights and samples.
    fn check_cutoff(&self) {
        let view = self.view();
        let objects = &mut view.world.objects().objects();
        // Flattened transforms also move shapes.
        if objects.any(|(geometry, _)| is_node(geometry)) {
            return;
        }
        // Mirrors may take an eighth of the error.
        let [whole, cut] = [None, Some(8.0 * self.cutoff)].map(|max_error| {
            let View { camera, world } = self.view();
            let view = View::new(Middles(camera), world);
            self.render(view, Renderer::Engine, max_error)
        });
        for (whole, cut) in channels(&whole).zip(channels(&cut)) {
            let bound = self.cutoff * (1.0 + 1e-12) + 1000.0 * f64::EPSILON * whole;
            assert!((whole - cut).abs() <= bound, "{whole}, {cut}: {self:?}");
        }
    }
}

fn channels(image: &Image) -> impl Iterator<Item = f64> {
    image.pixels().iter().flat_map(|color| color.channels())
}

/// A camera whose rays all go through the middles of pixels.
struct Middles(Box<dyn Camera>);

impl Camera for Middles {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        self.0.ray_for(size, libm::round(x), libm::round(y))
    }
}

fn is_node(geometry: &dyn Geometry) -> bool {
    let any: &dyn Any = geometry;
    any.downcast_ref::<Box<dyn Geometry>>()
        .map_or_else(|| any.is::<Node>(), |boxed| is_node(&**boxed))
}

fn settings(u: &mut Unstructured) -> Result<Settings> {
    let [width, height] = [u.int_in_range(1..=4)?, u.int_in_range(1..=4)?];
    let error = u.ratio(1, 4)?.then(|| u.int_in_range(1..=255_u8));
    let error = error.transpose()?;
    Ok(Settings {
        size: Size::new(width, height).expect("a size"),
        samples: u.int_in_range(1..=4)?,
        sampling: *u.choose(&Sampling::ALL)?,
        max_error: error.map(|error| f64::from(error) / 512.0),
        seed: u.arbitrary::<u8>()?.into(),
        depth: u.int_in_range(1..=8)?,
        ..Settings::default()
    })
}

/// Up to three lights and twelve objects.
fn world(u: &mut Unstructured) -> Result<ShadowedWorld> {
    let (background, ambient) = (color(u)?, color(u)?);
    let empty = accepted(ShadowedWorld::empty(background, ambient));
    let dark = || ShadowedWorld::empty(Color::BLACK, Color::gray(0.1)).expect("a world");
    let mut world = empty.unwrap_or_else(dark);
    for _ in 0..u.int_in_range(0..=3)? {
        if let Some(light) = light(u)? {
            world = world.lit_by(light);
        }
    }
    for _ in 0..u.int_in_range(0..=12)? {
        if let (Some(shape), Some(surface)) = (shape(u)?, surface(u)?) {
            world = world.with(shape, surface);
        }
    }
    Ok(world)
}

fn light(u: &mut Unstructured) -> Result<Option<LightSource>> {
    fn source<L: Light + 'static>(
        made: std::result::Result<L, ArgumentError>,
        casts_shadows: bool,
    ) -> Option<LightSource> {
        accepted(made).map(|light| LightSource::new(light, casts_shadows))
    }
    let (kind, casts_shadows, color) = (u.int_in_range(0..=3)?, u.ratio(3, 4)?, color(u)?);
    Ok(match kind {
        0 => source(DirectionalLight::new(color, vector(u)?), casts_shadows),
        1 => {
            let spot = SpotLight::new(color, point(u)?, vector(u)?, number(u)?);
            source(spot, casts_shadows)
        }
        _ => source(PointLight::new(color, point(u)?), casts_shadows),
    })
}

fn surface(u: &mut Unstructured) -> Result<Option<Box<dyn Surface>>> {
    fn boxed<S: Surface + 'static>(
        made: std::result::Result<S, ArgumentError>,
    ) -> Option<Box<dyn Surface>> {
        accepted(made).map(|surface| Box::new(surface) as _)
    }
    Ok(match u.int_in_range(0..=4)? {
        0 => boxed(SingleColor::new(color(u)?)),
        1 => boxed(Lambert::new(color(u)?)),
        2 => boxed(Phong::new(color(u)?, color(u)?, number(u)?)),
        _ => boxed(Reflective::new(color(u)?, color(u)?, number(u)?, color(u)?)),
    })
}
