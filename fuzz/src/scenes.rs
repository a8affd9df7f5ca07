//! Whole scenes of any numbers. What the constructors let pass is rendered:
//! every pixel must be a finite number, and the same to the last bit with work
//! left out, four rays at a time, and without, each ray alone.

use a03_rays_cameras::{Camera, render_together};
use a05_lighting::{DirectionalLight, Lambert, Light, Phong, PointLight, SingleColor, SpotLight};
use a06_shadows_reflection::{
    LightSource, RecursiveTracer, Reflective, ShadowedWorld, Surface, TracedLight, foci,
};
use arbitrary::{Result, Unstructured};
use common::{ArgumentError, Color, Image, Renderer, Sampling, Settings, Size};

use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::number::{color, number, point, vector};
use crate::shapes::{accepted, camera, shape};

/// Renders the scene that the bytes make, twice.
///
/// # Panics
///
/// If a pixel is no finite number or negative, if leaving out work changes a
/// bit where no error is allowed, or if mirrored light that is cut off is more than
/// was allowed.
pub fn check(bytes: &[u8]) {
    let (Ok(lazy), Ok(thorough)) = (
        Scene::new(bytes, Renderer::Lesson),
        Scene::new(bytes, Renderer::AllWork),
    ) else {
        return;
    };
    let (picture, expected) = (lazy.picture(), thorough.picture());
    // Where an error is allowed, a searched world is looked at in fewer places, and
    // what was added to a pixel and taken off again is rounded.
    let adaptive = lazy.settings.max_error.is_some();
    let least = if adaptive { -1e-9 } else { 0.0 };
    for (pixel, expected) in picture.pixels().iter().zip(expected.pixels()) {
        let [bits, expected_bits] = [pixel, expected].map(|c| c.channels().map(f64::to_bits));
        let same = adaptive || bits == expected_bits;
        assert!(same, "{pixel:?}, {expected:?}: {lazy:?}");
        let holds = |channel: f64| channel.is_finite() && channel >= least;
        assert!(
            pixel.channels().into_iter().all(holds),
            "{pixel:?}: {lazy:?}"
        );
    }
    lazy.check_cut();
}

struct Scene {
    settings: Settings,
    camera: Box<dyn Camera>,
    world: ShadowedWorld,
    /// What may be left out of mirrored light.
    unseen: f64,
}

impl std::fmt::Debug for Scene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let rays = self.rays().collect::<Vec<_>>();
        write!(f, "{:#?}\n{:#?}\n{rays:#?}", self.settings, self.world)
    }
}

impl Scene {
    /// The same bytes make the same scene.
    fn new(bytes: &[u8], renderer: Renderer) -> Result<Self> {
        let u = &mut Unstructured::new(bytes);
        let settings = settings(u, renderer)?;
        let unseen = f64::from(u.arbitrary::<u8>()?) / 512.0;
        let camera = camera(u)?;
        let world = world(u)?;
        let foci = foci(&camera, &world);
        Ok(Self {
            settings,
            camera,
            world: world.omitting(renderer != Renderer::AllWork, foci),
            unseen,
        })
    }

    /// On this thread: to wake another takes longer than so small a picture.
    fn picture(&self) -> Image {
        thread_local! {
            static ALONE: ThreadPool = ThreadPoolBuilder::new()
                .num_threads(1)
                .use_current_thread()
                .build()
                .expect("a pool of this thread");
        }
        ALONE.with(|pool| pool.install(|| self.render()))
    }

    fn render(&self) -> Image {
        let light = TracedLight {
            tracer: RecursiveTracer::new(&self.world, self.settings.renderer != Renderer::AllWork),
            depth: self.settings.depth,
        };
        render_together(&*self.camera, light, &self.settings, &()).expect("a picture")
    }

    /// The rays through the middles of the pixels.
    fn rays(&self) -> impl Iterator<Item = a03_rays_cameras::Ray> {
        let size = self.settings.size;
        let places = (0..size.height()).flat_map(move |y| (0..size.width()).map(move |x| (x, y)));
        places.map(move |(x, y)| self.camera.ray_for(size, x.into(), y.into()))
    }

    /// Bound: what may be unseen, and the rounding of as many sums as there are
    /// surfaces and lights.
    fn check_cut(&self) {
        let whole = RecursiveTracer::new(&self.world, true);
        let cut = whole.cut_below(Some(self.unseen));
        for ray in self.rays() {
            let [whole, cut] = [whole, cut].map(|tracer| tracer.trace(&ray, self.settings.depth));
            for (whole, cut) in whole.channels().into_iter().zip(cut.channels()) {
                let bound = self.unseen * (1.0 + 1e-12) + 100.0 * f64::EPSILON * whole;
                assert!((whole - cut).abs() <= bound, "{whole}, {cut}: {self:?}");
            }
        }
    }
}

fn settings(u: &mut Unstructured, renderer: Renderer) -> Result<Settings> {
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
        renderer,
        file: None,
    })
}

/// Up to three lights and twelve objects; a world of few is not searched.
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
