//! Whole scenes of any numbers. Each one that the constructors accept is rendered:
//! every pixel must be a finite number, and the same to the last bit by the
//! lesson and with all work.

use a03_rays_cameras::{Camera, Ray, render};
use a05_lighting::{DirectionalLight, Lambert, Light, Phong, PointLight, SingleColor, SpotLight};
use a06_shadows_reflection::all_work::{self, NaiveTracer};
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface};
use arbitrary::{Result, Unstructured};
use common::{ArgumentError, Color, Image, Sampling, Settings, Size};

use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::number::{color, number, point, vector};
use crate::shapes::{accepted, camera, shape};

/// Renders the scene that the bytes make, twice.
///
/// # Panics
///
/// If a pixel is no finite number or negative, or if all work changes a bit.
pub fn check(bytes: &[u8]) {
    let (Ok(scene), Ok(same)) = (Scene::new(bytes), Scene::new(bytes)) else {
        return;
    };
    let all = all_work::world(same.world).expect("a world of the same colours");
    let (lesson, naive) = (RecursiveTracer::new(&scene.world), NaiveTracer::new(&all));
    let depth = scene.settings.depth;
    let picture = scene.picture(|ray| lesson.trace(ray, depth));
    let expected = scene.picture(|ray| naive.trace(ray, depth));
    for (pixel, expected) in picture.pixels().iter().zip(expected.pixels()) {
        let [bits, expected_bits] = [pixel, expected].map(|c| c.channels().map(f64::to_bits));
        assert_eq!(bits, expected_bits, "{pixel:?}, {expected:?}: {scene:?}");
        let holds = |channel: f64| channel.is_finite() && channel >= 0.0;
        assert!(
            pixel.channels().into_iter().all(holds),
            "{pixel:?}: {scene:?}"
        );
    }
}

struct Scene {
    settings: Settings,
    camera: Box<dyn Camera>,
    world: ShadowedWorld,
}

impl std::fmt::Debug for Scene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let rays = self.rays().collect::<Vec<_>>();
        write!(f, "{:#?}\n{:#?}\n{rays:#?}", self.settings, self.world)
    }
}

impl Scene {
    /// The same bytes make the same scene.
    fn new(bytes: &[u8]) -> Result<Self> {
        let u = &mut Unstructured::new(bytes);
        let settings = settings(u)?;
        // A byte that the seeds still have.
        let _: u8 = u.arbitrary()?;
        Ok(Self {
            settings,
            camera: camera(u)?,
            world: world(u)?,
        })
    }

    /// On this thread: to wake another takes longer than so small a picture.
    fn picture(&self, radiance: impl Fn(&Ray) -> Color + Send + Sync) -> Image {
        thread_local! {
            static ALONE: ThreadPool = ThreadPoolBuilder::new()
                .num_threads(1)
                .use_current_thread()
                .build()
                .expect("a pool of this thread");
        }
        let render = || render(&*self.camera, radiance, &self.settings, &());
        ALONE.with(|pool| pool.install(render)).expect("a picture")
    }

    /// The rays through the middles of the pixels.
    fn rays(&self) -> impl Iterator<Item = Ray> {
        let size = self.settings.size;
        let places = (0..size.height()).flat_map(move |y| (0..size.width()).map(move |x| (x, y)));
        places.map(move |(x, y)| self.camera.ray_for(size, x.into(), y.into()))
    }
}

fn settings(u: &mut Unstructured) -> Result<Settings> {
    let [width, height] = [u.int_in_range(1..=4)?, u.int_in_range(1..=4)?];
    let error = u.ratio(1, 4)?.then(|| u.int_in_range(1..=255_u8));
    let error = error.transpose()?;
    Ok(Settings {
        size: Size::new(width, height).expect("a size"),
        rows: None,
        samples: u.int_in_range(1..=4)?,
        sampling: *u.choose(&[
            Sampling::Center,
            Sampling::Regular,
            Sampling::Random,
            Sampling::Stratified,
        ])?,
        max_error: error.map(|error| f64::from(error) / 512.0),
        seed: u.arbitrary::<u8>()?.into(),
        depth: u.int_in_range(1..=8)?,
        file: None,
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
