//! Adaptive sampling takes more samples where an object narrow enough to be missed may
//! be: where a radiance announces it, and where the engine finds it by the sizes of the
//! features of a scene.

mod support;

use std::sync::Mutex;

use common::{Color, Image, Sampled, Settings};
use engine::adaptive::{Radiance, render};
use engine::{
    Basis, Camera, Hit, Interval, Light, LightKind, Phong, Plane, Ray, Renderer, Sampler, Scene,
    Shading, Shape, Sphere, Surface,
};
use glam::DVec3;
use measure::experiment::HALF_GREY_LEVEL;

use support::{root_mean_square, settings, stratified};

/// Light whose features are at least this wide, in pixels.
struct Known {
    light: fn(f64, f64) -> f64,
    narrowest: f64,
}

impl Radiance for Known {
    fn light(&self, places: &[(f64, f64)], light: &mut Vec<Color>) {
        let at = |(x, y): &(f64, f64)| Color::gray((self.light)(*x, *y));
        light.clear();
        light.extend(places.iter().map(at));
    }

    fn may_miss_features(&self, [a, b, c, d]: &[(f64, f64); 4], feature_size: f64) -> bool {
        let side = b.0 - a.0;
        assert_eq!([b.1 - a.1, c.0 - a.0, d.0 - b.0], [0.0; 3]);
        assert_eq!([c.1 - a.1, d.1 - b.1], [-side; 2]);
        assert_eq!(d.0 - c.0, side);
        self.narrowest < side * feature_size
    }
}

fn adaptive(radiance: &impl Radiance, settings: &Settings) -> (Image, Sampled) {
    let sampled = Mutex::new(Sampled::default());
    let mut image = Image::black(settings.size).unwrap();
    let copy = |colors: &[Color], pixels: &mut [Color]| pixels.copy_from_slice(colors);
    let (max_error, pixels) = (settings.max_error.unwrap(), image.pixels_mut());
    render(max_error, settings, radiance, &sampled, pixels, copy).unwrap();
    (image, sampled.into_inner().unwrap())
}

#[test]
fn without_narrow_features_smooth_light_takes_a_fraction_of_a_sample_a_pixel() {
    let known = Known {
        light: |x, y| (2.0 * x + y) / 256.0,
        narrowest: 16.0,
    };
    let settings = settings(HALF_GREY_LEVEL);
    let (image, sampled) = adaptive(&known, &settings);
    assert!(sampled.samples < sampled.pixels / 8, "{sampled}");
    let reference = stratified(|x, y| Color::gray((known.light)(x, y)), settings.size, 64);
    assert!(root_mean_square(&image, &reference) < 1e-4);
}

/// A disc 1.6 pixels wide around a corner of pixels that is no corner of a block.
#[test]
fn a_narrow_feature_is_found_where_it_is_announced() {
    let disc: fn(f64, f64) -> f64 = |x, y| {
        let (x, y) = (x - 40.5, y - 30.5);
        f64::from(u8::from(x * x + y * y < 0.8 * 0.8))
    };
    let settings = settings(HALF_GREY_LEVEL);
    let reference = stratified(|x, y| Color::gray(disc(x, y)), settings.size, 64);
    let error = |narrowest| {
        let light = disc;
        let (image, _) = adaptive(&Known { light, narrowest }, &settings);
        root_mean_square(&image, &reference)
    };
    // One small disc has too few cells for their errors to cancel out.
    assert!(error(1.6) < 1.5 * HALF_GREY_LEVEL);
    assert!(error(16.0) > 5.0 * HALF_GREY_LEVEL);
}

/// A pixel is 1 wide where z is 0, and coordinates there are places in the picture. The
/// eye is far above its middle, so that spheres appear as discs.
const EYE: DVec3 = DVec3::new(39.5, 29.5, 1000.0);

fn from_above() -> Camera<'static> {
    let basis = Basis {
        e: EYE,
        u: DVec3::X,
        v: DVec3::Y,
        w: DVec3::Z,
    };
    Camera::Perspective {
        basis,
        half_tangent: 30.0 / 1000.0,
    }
}

fn ray((x, y): (f64, f64)) -> Ray {
    Ray {
        origin: EYE,
        direction: (DVec3::new(x, y, 0.0) - EYE).normalize(),
    }
}

fn matt(gray: f64) -> Surface<'static> {
    Surface::matt(Shading::Phong(Phong {
        diffuse: Color::gray(gray),
        specular: Color::BLACK,
        exponent: 0.0,
    }))
}

/// A white shape and a black floor far below it, in light that falls as the eye looks.
fn scene(shape: Option<Shape<'static>>) -> Scene<'static> {
    let mut scene = Scene::new(Color::BLACK, Color::gray(0.5), 1);
    scene.add_light(Light {
        kind: LightKind::Directional {
            color: Color::gray(0.5),
            direction: -DVec3::Z,
        },
        casts_shadows: true,
    });
    let [black, white] = [0.0, 1.0].map(|gray| scene.add_surface(matt(gray)));
    let floor = Plane {
        point: DVec3::new(0.0, 0.0, -5000.0),
        normal: DVec3::Z,
    };
    scene.add_shape(Shape::Plane(floor), black);
    if let Some(shape) = shape {
        scene.add_shape(shape, white);
    }
    scene
}

/// A disc 1.6 pixels wide around a corner of pixels that is no corner of a block.
const SMALL: Sphere = Sphere {
    center: DVec3::new(40.5, 30.5, 0.0),
    radius: 0.8,
};

/// It fills the picture. At the corners, 50 from the middle, its normal is less than 3
/// degrees from the light, whose share changes by a thousandth.
const LARGE: Sphere = Sphere {
    center: DVec3::new(39.5, 29.5, -1000.0),
    radius: 1000.0,
};

/// A sphere as a shape of a type that the engine does not know.
fn unknown(sphere: Sphere) -> Shape<'static> {
    Shape::other(move |ray: &Ray, within: Interval| {
        let f = ray.origin - sphere.center;
        let middle = -f.dot(ray.direction);
        let beside = f + ray.direction * middle;
        let squared = sphere.radius * sphere.radius - beside.dot(beside);
        let t = middle - squared.sqrt();
        let normal = (f + ray.direction * t) / sphere.radius;
        within.contains(t).then(|| Hit::new(t, normal))
    })
}

/// One sample in the middle; adaptive sampling has its own places.
struct Middle;

impl Sampler for Middle {
    fn samples(&self) -> u32 {
        1
    }

    fn place(&self, _: u32, _: u32, _: u32) -> (f64, f64) {
        (0.5, 0.5)
    }
}

fn rendered(scene: Scene, camera: Camera) -> (Image, Sampled) {
    let (sampled, settings) = (Mutex::new(Sampled::default()), settings(HALF_GREY_LEVEL));
    let renderer = Renderer::new(scene, camera, &settings);
    let image = renderer.render(&Middle, &settings, &sampled).unwrap();
    (image, sampled.into_inner().unwrap())
}

/// The light of a scene, for places of the picture; it announces no narrow feature.
struct Unannounced<'a>(Renderer<'a>);

impl<'a> Unannounced<'a> {
    fn new(scene: Scene<'a>) -> Self {
        Self(Renderer::new(scene, from_above(), &Settings::default()))
    }

    fn at(&self, x: f64, y: f64) -> Color {
        let mut light = [Color::BLACK];
        self.0.trace(&[ray((x, y))], &mut light);
        light[0]
    }
}

impl Radiance for Unannounced<'_> {
    fn light(&self, places: &[(f64, f64)], light: &mut Vec<Color>) {
        let rays: Vec<_> = places.iter().copied().map(ray).collect();
        light.resize(rays.len(), Color::BLACK);
        self.0.trace(&rays, light);
    }

    fn may_miss_features(&self, _: &[(f64, f64); 4], _: f64) -> bool {
        false
    }
}

fn error(image: &Image, shape: Option<Shape<'static>>) -> f64 {
    let exact = Unannounced::new(scene(shape));
    let reference = stratified(|x, y| exact.at(x, y), image.size(), 32);
    root_mean_square(image, &reference)
}

#[test]
fn a_small_sphere_alone_is_found() {
    let small = || Some(Shape::Sphere(SMALL));
    let (found, _) = rendered(scene(small()), from_above());
    let found = error(&found, small());
    // One small disc has too few cells for their errors to cancel out.
    assert!(found < 1.5 * HALF_GREY_LEVEL, "{found}");
    let unannounced = Unannounced::new(scene(small()));
    let (missed, _) = adaptive(&unannounced, &settings(HALF_GREY_LEVEL));
    let missed = error(&missed, small());
    assert!(missed > 5.0 * HALF_GREY_LEVEL, "{missed}");
}

#[test]
fn a_small_sphere_takes_more_samples_near_it_only() {
    let (_, sampled) = rendered(scene(Some(Shape::Sphere(SMALL))), from_above());
    assert!(sampled.samples < sampled.pixels / 5, "{sampled}");
}

#[test]
fn large_smooth_shapes_take_a_fraction_of_a_sample_a_pixel() {
    for shape in [|| None, || Some(Shape::Sphere(LARGE))] {
        let (image, sampled) = rendered(scene(shape()), from_above());
        assert_eq!(sampled.most, 1);
        assert!(sampled.samples < sampled.pixels / 8, "{sampled}");
        let error = error(&image, shape());
        assert!(error < 1e-4, "{error}");
    }
}

/// Nothing is known of the size of an unknown shape, and of features between the rays of
/// an unknown camera.
#[test]
fn unknown_shapes_and_cameras_take_a_sample_a_pixel() {
    let camera = || Camera::Other(Box::new(|_, x, y| ray((x, y))));
    for (shape, camera) in [
        (unknown(LARGE), from_above()),
        (Shape::Sphere(LARGE), camera()),
    ] {
        let (_, sampled) = rendered(scene(Some(shape)), camera);
        assert!(sampled.samples >= sampled.pixels, "{sampled}");
    }
    for (shape, camera) in [
        (unknown(SMALL), from_above()),
        (Shape::Sphere(SMALL), camera()),
    ] {
        let (image, _) = rendered(scene(Some(shape)), camera);
        let error = error(&image, Some(Shape::Sphere(SMALL)));
        assert!(error < 1.5 * HALF_GREY_LEVEL, "{error}");
    }
}
