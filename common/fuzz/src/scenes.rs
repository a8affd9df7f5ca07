//! Whole scenes of any numbers. Each one that the constructors accept is rendered:
//! every pixel must be a finite number, and the same to the last bit by the lesson, by
//! the engine and with all work. Adaptive sampling must end with finite numbers, and cut
//! off only mirrored light below its threshold.

use a03_rays_cameras::{Camera, Ray, View};
use a05_lighting::{DirectionalLight, Lambert, Phong, PointLight, SingleColor, SpotLight};
use a06_shadows_reflection::{LightSource, Reflective, ShadowedWorld, Surface};
use a07_transforms::traced;
use arbitrary::{Result, Unstructured};
use common::{Color, Renderer, Sampling, Settings, Size};

use crate::values::{accepted, boxed, camera, color, number, point, shape, vector};

/// Renders the scene that the bytes make by all three renderers.
pub fn check(bytes: &[u8]) {
    let Ok(scene) = Scene::new(bytes) else {
        return;
    };
    let lesson = scene.channels(Renderer::Lesson, None);
    scene.check(lesson.iter().all(|c| c.is_finite() && *c >= 0.0), &lesson);
    for renderer in [Renderer::Engine, Renderer::NoOmissions] {
        let other = scene.channels(renderer, None);
        scene.check(are_same_bits(&lesson, &other), &other);
    }
    if scene.settings.max_error.is_some() {
        for renderer in [Renderer::Lesson, Renderer::Engine] {
            let adaptive = scene.channels(renderer, scene.settings.max_error);
            // Light that was added to a pixel and taken off again is rounded.
            let is_right = |c: &f64| c.is_finite() && *c >= -1e-9;
            scene.check(adaptive.iter().all(is_right), &adaptive);
        }
    }
    scene.check_cutoff();
}

fn are_same_bits(a: &[f64], b: &[f64]) -> bool {
    let mut pairs = a.iter().zip(b);
    a.len() == b.len() && pairs.all(|(a, b)| a.to_bits() == b.to_bits())
}

/// A scene made of bytes.
struct Scene<'a> {
    /// The same bytes make the same view.
    bytes: &'a [u8],
    settings: Settings,
    /// The threshold for mirrored light.
    cutoff: f64,
    view: View<ShadowedWorld>,
}

impl<'a> Scene<'a> {
    fn new(bytes: &'a [u8]) -> Result<Self> {
        let u = &mut Unstructured::new(bytes);
        let settings = settings(u)?;
        let cutoff = f64::from(u.arbitrary::<u8>()?) / 512.0;
        let (camera, world) = (camera(u)?, world(u)?);
        Ok(Self {
            bytes,
            settings,
            cutoff,
            view: View { camera, world },
        })
    }

    /// The view once more.
    fn view_again(&self) -> View<ShadowedWorld> {
        Self::new(self.bytes).expect("it was made before").view
    }

    /// The channels of the scene's picture.
    fn channels(&self, renderer: Renderer, max_error: Option<f64>) -> Vec<f64> {
        self.channels_of(self.view_again(), renderer, max_error)
    }

    fn channels_of(
        &self,
        view: View<ShadowedWorld>,
        renderer: Renderer,
        max_error: Option<f64>,
    ) -> Vec<f64> {
        let settings = Settings {
            renderer,
            max_error,
            ..self.settings.clone()
        };
        let image = traced(view).render(&settings, &()).expect("a picture");
        let mut channels = Vec::new();
        for color in image.pixels() {
            channels.extend(color.channels());
        }
        channels
    }

    /// Fails with the scene in words, if these channels are not right.
    fn check(&self, is_right: bool, channels: &[f64]) {
        let (settings, world) = (&self.settings, &self.view.world);
        assert!(is_right, "{channels:?}: {settings:#?}\n{world:#?}");
    }

    /// Compares pictures with and without the cutoff of reflections. All rays of a pixel are the
    /// same, so that nothing else differs.
    fn check_cutoff(&self) {
        let render = |max_error| {
            let View { camera, world } = self.view_again();
            let view = View::new(Middles(camera), world);
            self.channels_of(view, Renderer::Engine, max_error)
        };
        let whole = render(None);
        // Mirrors may take an eighth of the error.
        let cut = render(Some(8.0 * self.cutoff));
        for (whole, cut_off) in whole.iter().zip(&cut) {
            // The threshold, and the rounding of the sums over surfaces, lights and samples.
            let threshold = self.cutoff * (1.0 + 1e-12);
            let rounding = 1000.0 * f64::EPSILON * whole;
            let is_near = (whole - cut_off).abs() <= threshold + rounding;
            self.check(is_near, &cut);
        }
    }
}

/// A camera whose rays all go through the middles of pixels.
struct Middles(Box<dyn Camera>);

impl Camera for Middles {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        self.0.ray_for(size, libm::round(x), libm::round(y))
    }
}

fn settings(u: &mut Unstructured) -> Result<Settings> {
    let size = Size::new(u.int_in_range(1..=4)?, u.int_in_range(1..=4)?);
    let error = u.arbitrary::<u8>()?;
    Ok(Settings {
        size: size.expect("a size"),
        samples: u.int_in_range(1..=4)?,
        sampling: *u.choose(&Sampling::ALL)?,
        max_error: (error < 64).then(|| f64::from(4 * error + 1) / 512.0),
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
        if let (Some(shape), Some(surface)) = (shape(u, 3)?, surface(u)?) {
            world = world.with(shape, surface);
        }
    }
    Ok(world)
}

fn light(u: &mut Unstructured) -> Result<Option<LightSource>> {
    let kind = u.int_in_range(0..=3)?;
    let casts_shadows = u.ratio(3, 4)?;
    let color = color(u)?;
    Ok(match kind {
        0 => {
            let light = DirectionalLight::new(color, vector(u)?);
            accepted(light).map(|light| LightSource::new(light, casts_shadows))
        }
        1 => {
            let light = SpotLight::new(color, point(u)?, vector(u)?, number(u)?);
            accepted(light).map(|light| LightSource::new(light, casts_shadows))
        }
        _ => {
            let light = PointLight::new(color, point(u)?);
            accepted(light).map(|light| LightSource::new(light, casts_shadows))
        }
    })
}

fn surface(u: &mut Unstructured) -> Result<Option<Box<dyn Surface>>> {
    let kind = u.int_in_range(0..=4)?;
    let diffuse = color(u)?;
    Ok(match kind {
        0 => boxed!(SingleColor::new(diffuse)),
        1 => boxed!(Lambert::new(diffuse)),
        2 => {
            let (specular, exponent) = (color(u)?, number(u)?);
            boxed!(Phong::new(diffuse, specular, exponent))
        }
        _ => {
            let (specular, exponent) = (color(u)?, number(u)?);
            let reflectance = color(u)?;
            boxed!(Reflective::new(diffuse, specular, exponent, reflectance))
        }
    })
}
