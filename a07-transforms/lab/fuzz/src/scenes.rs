//! Whole scenes of any numbers. Each one that the constructors accept is rendered:
//! every pixel must be a finite number, and the same to the last bit by the lesson, by
//! the engine and with all work. Adaptive sampling must end with finite numbers, and cut
//! off only mirrored light below its threshold.

use a03_rays_cameras::{Camera, Ray, View};
use a04_intersections::{Geometry, Interval};
use a06_shadows_reflection::ShadowedWorld;
use a06_shadows_reflection::registry::read_view;
use a07_transforms::registry::{ALL_SHAPES, FORMAT};
use a07_transforms::traced;
use arbitrary::{Result, Unstructured};
use common::{Renderer, Sampling, Settings, Size};
use random_scene::SceneText;
use scene_file::Error;

use crate::scene_files;
use crate::values::{accepted, assert_unit, number, point, size_and_ray, vector};

/// Renders the scene that the bytes make by all three renderers.
pub fn check(bytes: &[u8]) {
    let u = &mut Unstructured::new(bytes);
    let Ok(scene) = Scene::new(u) else {
        return;
    };
    // Each table is right by itself, and not always all of them together.
    let Ok(view) = view(&scene.text) else {
        return;
    };
    size_and_ray(u, &*view.camera).expect("numbers");
    for (shape, _) in view.world.objects().objects() {
        check_hits(u, shape).expect("numbers");
    }
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
struct Scene {
    text: SceneText,
    settings: Settings,
    /// The threshold for mirrored light.
    cutoff: f64,
}

impl Scene {
    fn new(u: &mut Unstructured) -> Result<Self> {
        Ok(Self {
            settings: settings(u)?,
            cutoff: f64::from(u.arbitrary::<u8>()?) / 512.0,
            text: scene_files::text(u, &|text| view(text).is_ok()),
        })
    }

    /// The channels of the scene's picture.
    fn channels(&self, renderer: Renderer, max_error: Option<f64>) -> Vec<f64> {
        self.channels_of(view(&self.text).expect("a view"), renderer, max_error)
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
        let (settings, text) = (&self.settings, &self.text);
        assert!(is_right, "{channels:?}: {settings:#?}\n{text:#?}");
    }

    /// Compares pictures with and without the cutoff of reflections. All rays of a pixel are the
    /// same, so that nothing else differs.
    fn check_cutoff(&self) {
        let render = |max_error| {
            let View { camera, world } = view(&self.text).expect("a view");
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

fn view(text: &SceneText) -> std::result::Result<View<ShadowedWorld>, Error> {
    let file = FORMAT.read(&text.scene, &|name| text.mesh(name))?;
    read_view(&file, ALL_SHAPES)
}

/// Hits of rays of a length that a node may give them, and of any at all.
fn check_hits(u: &mut Unstructured, shape: &dyn Geometry) -> Result<()> {
    let (min, max) = (number(u)?, number(u)?);
    let (origin, direction) = (point(u)?, vector(u)?);
    let mut rays = vec![Ray::derived(origin, direction)];
    rays.extend(accepted(Ray::new(origin, direction)));
    for ray in rays {
        for within in [Interval { min, max }, Interval::AHEAD] {
            if let Some(hit) = shape.hit(&ray, within) {
                assert!(within.contains(hit.t), "{hit:?}: {shape:?} {ray:?}");
                assert_unit(hit.normal.into());
                assert_unit(hit.geometric_normal.into());
            }
        }
    }
    Ok(())
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
