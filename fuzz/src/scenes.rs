//! Whole scenes of any numbers. Each one that the constructors accept is rendered:
//! every pixel must be a finite number, and the same to the last bit by the lesson, by
//! the engine and with all work. Adaptive sampling must end with finite numbers, and cut
//! off only mirrored light below its threshold.

use std::any::Any;

use a03_rays_cameras::fast::{camera as camera_of_engine, render_by_engine, render_by_lesson};
use a03_rays_cameras::{Camera, Ray};
use a04_intersections::Geometry;
use a05_lighting::{DirectionalLight, Lambert, Light, Phong, PointLight, SingleColor, SpotLight};
use a06_shadows_reflection::all_work::{self, NaiveTracer};
use a06_shadows_reflection::{
    LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface, fast,
};
use a07_transforms::Node;
use a07_transforms::fast::shapes;
use arbitrary::{Result, Unstructured};
use common::{ArgumentError, Color, Error, Image, Sampling, Settings, Size};
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::number::{color, number, point, vector};
use crate::shapes::{accepted, camera, shape};

/// Renders the scene that the bytes make by all three renderers.
pub fn check(bytes: &[u8]) {
    let (Ok(scene), Ok(same)) = (Scene::new(bytes), Scene::new(bytes)) else {
        return;
    };
    let picture = scene.by_lesson(&scene.settings);
    scene.check_pixels(&picture, 0.0);
    scene.check_same(&scene.by_engine(&scene.settings), &picture);
    scene.check_same(&same.by_all_work(), &picture);
    scene.check_adaptive();
    scene.check_cutoff();
}

struct Scene {
    /// Without an error: all renderers make the same picture.
    settings: Settings,
    max_error: Option<f64>,
    /// Mirrored light below this may be cut off.
    cutoff: f64,
    camera: Box<dyn Camera>,
    world: ShadowedWorld,
}

impl std::fmt::Debug for Scene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let rays = self.rays().collect::<Vec<_>>();
        write!(f, "{:#?}\n{:#?}\n{rays:#?}", self.settings, self.world)
    }
}

/// On this thread: to wake another takes longer than so small a picture.
fn alone(render: impl FnOnce() -> std::result::Result<Image, Error> + Send) -> Image {
    thread_local! {
        static ALONE: ThreadPool = ThreadPoolBuilder::new()
            .num_threads(1)
            .use_current_thread()
            .build()
            .expect("a pool of this thread");
    }
    ALONE.with(|pool| pool.install(render)).expect("a picture")
}

impl Scene {
    /// The same bytes make the same scene.
    fn new(bytes: &[u8]) -> Result<Self> {
        let u = &mut Unstructured::new(bytes);
        let settings = settings(u)?;
        Ok(Self {
            max_error: settings.max_error,
            settings: Settings {
                max_error: None,
                ..settings
            },
            cutoff: f64::from(u.arbitrary::<u8>()?) / 512.0,
            camera: camera(u)?,
            world: world(u)?,
        })
    }

    fn by_lesson(&self, settings: &Settings) -> Image {
        let (camera, tracer) = (&*self.camera, RecursiveTracer::new(&self.world));
        let radiance = |ray: &Ray| tracer.trace(ray, settings.depth);
        alone(|| render_by_lesson(camera, radiance, settings, &()))
    }

    fn by_engine(&self, settings: &Settings) -> Image {
        let camera = &*self.camera;
        alone(|| {
            let scene = fast::scene(&self.world, settings.depth, shapes);
            render_by_engine(scene, camera, settings, &())
        })
    }

    fn by_all_work(self) -> Image {
        let (camera, settings) = (&*self.camera, &self.settings);
        let world = all_work::world(self.world).expect("a world of the same colours");
        let tracer = NaiveTracer::new(&world);
        let radiance = |ray: &Ray| tracer.trace(ray, settings.depth);
        alone(|| a03_rays_cameras::all_work::render(camera, radiance, settings, &()))
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

    fn check_adaptive(&self) {
        let Some(max_error) = self.max_error else {
            return;
        };
        let settings = Settings {
            max_error: Some(max_error),
            ..self.settings.clone()
        };
        // Light that was added to a pixel and taken off again is rounded.
        self.check_pixels(&self.by_lesson(&settings), -1e-9);
        self.check_pixels(&self.by_engine(&settings), -1e-9);
    }

    /// Bound: the threshold, and the rounding of as many sums as there are surfaces and
    /// lights.
    fn check_cutoff(&self) {
        let objects = &mut self.world.objects().objects();
        // Flattened transforms also move shapes.
        if objects.any(|(geometry, _)| is_node(geometry)) {
            return;
        }
        let prepared = |max_error| {
            let scene = fast::scene(&self.world, self.settings.depth, shapes);
            let settings = Settings {
                max_error,
                ..self.settings.clone()
            };
            engine::Renderer::new(scene, camera_of_engine(&*self.camera), &settings)
        };
        // Mirrors may take an eighth of the error.
        let max_error = 8.0 * self.cutoff;
        let rays: Vec<_> = self.rays().map(|ray| engine::Ray::from(&ray)).collect();
        let [whole, cut] = [None, Some(max_error)].map(|max_error| {
            let mut light = vec![Color::BLACK; rays.len()];
            prepared(max_error).trace(&rays, &mut light);
            light
        });
        let channels = |light: Vec<Color>| light.into_iter().flat_map(Color::channels);
        for (whole, cut) in channels(whole).zip(channels(cut)) {
            let bound = self.cutoff * (1.0 + 1e-12) + 100.0 * f64::EPSILON * whole;
            assert!((whole - cut).abs() <= bound, "{whole}, {cut}: {self:?}");
        }
    }

    /// The rays through the middles of the pixels.
    fn rays(&self) -> impl Iterator<Item = Ray> {
        let size = self.settings.size;
        let places = (0..size.height()).flat_map(move |y| (0..size.width()).map(move |x| (x, y)));
        places.map(move |(x, y)| self.camera.ray_for(size, x.into(), y.into()))
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
