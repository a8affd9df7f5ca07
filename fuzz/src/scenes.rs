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
    let Ok((settings, cutoff, View { world, .. })) = scene(bytes) else {
        return;
    };
    let check = |is_right: bool, channels: &[f64]| {
        assert!(is_right, "{channels:?}: {settings:#?}\n{world:#?}");
    };
    // The same bytes make the same view.
    let view = || scene(bytes).expect("it was made before").2;
    let render = |view: View<ShadowedWorld>, renderer, max_error| {
        let settings = Settings {
            renderer,
            max_error,
            ..settings.clone()
        };
        let image = traced(view).render(&settings, &()).expect("a picture");
        let channels = image.pixels().iter().flat_map(|color| color.channels());
        channels.collect::<Vec<_>>()
    };

    let lesson = render(view(), Renderer::Lesson, None);
    check(lesson.iter().all(|c| c.is_finite() && *c >= 0.0), &lesson);
    for renderer in [Renderer::Engine, Renderer::AllWork] {
        let same = render(view(), renderer, None);
        let bits = |channels: &[f64]| channels.iter().map(|c| c.to_bits()).collect::<Vec<_>>();
        check(bits(&same) == bits(&lesson), &same);
    }
    if settings.max_error.is_some() {
        for renderer in [Renderer::Lesson, Renderer::Engine] {
            let adaptive = render(view(), renderer, settings.max_error);
            // Light that was added to a pixel and taken off again is rounded.
            let is_right = |c: &f64| c.is_finite() && *c >= -1e-9;
            check(adaptive.iter().all(is_right), &adaptive);
        }
    }

    // Flattened transforms also move shapes.
    if !format!("{world:?}").contains("Node {") {
        // All rays of a pixel are the same, so that only the cutoff of reflections differs.
        // Mirrors may take an eighth of the error.
        let [whole, cut] = [None, Some(8.0 * cutoff)].map(|max_error| {
            let View { camera, world } = view();
            let view = View::new(Middles(camera), world);
            render(view, Renderer::Engine, max_error)
        });
        // The threshold, and the rounding of the sums over surfaces, lights and samples.
        let bound = |whole: f64| cutoff * (1.0 + 1e-12) + 1000.0 * f64::EPSILON * whole;
        let is_near = |(whole, cut): (&f64, &f64)| (whole - cut).abs() <= bound(*whole);
        check(whole.iter().zip(&cut).all(is_near), &cut);
    }
}

/// The settings, the threshold for mirrored light, and the view that the bytes make.
fn scene(bytes: &[u8]) -> Result<(Settings, f64, View<ShadowedWorld>)> {
    let u = &mut Unstructured::new(bytes);
    let (settings, cutoff) = (settings(u)?, f64::from(u.arbitrary::<u8>()?) / 512.0);
    let (camera, world) = (camera(u)?, world(u)?);
    Ok((settings, cutoff, View { camera, world }))
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
        world = light(u)?.into_iter().fold(world, ShadowedWorld::lit_by);
    }
    for _ in 0..u.int_in_range(0..=12)? {
        if let (Some(shape), Some(surface)) = (shape(u, 3)?, surface(u)?) {
            world = world.with(shape, surface);
        }
    }
    Ok(world)
}

fn light(u: &mut Unstructured) -> Result<Option<LightSource>> {
    let (kind, casts_shadows, color) = (u.int_in_range(0..=3)?, u.ratio(3, 4)?, color(u)?);
    macro_rules! source {
        ($made:expr) => {
            accepted($made).map(|light| LightSource::new(light, casts_shadows))
        };
    }
    Ok(match kind {
        0 => source!(DirectionalLight::new(color, vector(u)?)),
        1 => source!(SpotLight::new(color, point(u)?, vector(u)?, number(u)?)),
        _ => source!(PointLight::new(color, point(u)?)),
    })
}

fn surface(u: &mut Unstructured) -> Result<Option<Box<dyn Surface>>> {
    Ok(match u.int_in_range(0..=4)? {
        0 => boxed!(SingleColor::new(color(u)?)),
        1 => boxed!(Lambert::new(color(u)?)),
        2 => boxed!(Phong::new(color(u)?, color(u)?, number(u)?)),
        _ => boxed!(Reflective::new(color(u)?, color(u)?, number(u)?, color(u)?)),
    })
}
