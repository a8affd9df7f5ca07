//! How time and memory grow with the number of objects.
//!
//! ```console
//! $ cargo bench -p engine --bench scaling
//! ```
//!
//! From ten spheres in a cube to a million, which fill a ninth of it. The nearest hits
//! of 65,536 rays are found: in a plain list, as far as one can wait for it; in the
//! prepared scene for rays of no bundle, such as reflected rays; and for rays from the
//! eye. The most memory that `build` allocates at once, divided by the number of
//! objects, is the memory of an object.

#[path = "../src/adaptive/random.rs"]
mod random;

use common::{Color, Settings};
use divan::counter::ItemsCount;
use divan::{AllocProfiler, Bencher};
use engine::{Basis, Camera, Hit, Interval, Ray, Renderer, Scene, Shading, Shape, Sphere, Surface};
use glam::DVec3;

use crate::random::PixelRandom;

#[global_allocator]
static ALLOCATOR: AllocProfiler = AllocProfiler::system();

fn main() {
    divan::main();
}

const COUNTS: [usize; 6] = [10, 100, 1_000, 10_000, 100_000, 1_000_000];
const RAYS: u32 = 65_536;
const EYE: DVec3 = DVec3::new(0.0, 2.0, 5.0);

/// Six numbers from -1 to 1 that belong to `i`; spheres and rays have others.
fn numbers(seed: u64, i: u32) -> [f64; 6] {
    let random = PixelRandom::new(seed, i, 0);
    std::array::from_fn(|n| 2.0 * random.uniform(n as u64) - 1.0)
}

/// Spheres as dense for any number of them: a ray passes by a few of them until it
/// hits one.
fn spheres(count: usize) -> impl Iterator<Item = Sphere> {
    let radius = 0.6 / libm::cbrt(count as f64);
    (0..count as u32).map(move |i| {
        let [x, y, z, ..] = numbers(1, i);
        let center = DVec3::new(x, y, z);
        Sphere { center, radius }
    })
}

fn prepare(
    shapes: impl Iterator<Item = Shape<'static>>,
    camera: Camera<'static>,
) -> Renderer<'static> {
    let mut scene = Scene::new(Color::BLACK, Color::BLACK, 1);
    let surface = scene.add_surface(Surface::matt(Shading::SingleColor(Color::WHITE)));
    for shape in shapes {
        scene.add_shape(shape, surface);
    }
    Renderer::new(scene, camera, &Settings::default())
}

/// A camera whose rays form no bundle.
fn anywhere() -> Camera<'static> {
    Camera::Other(Box::new(|_, _, _| ray(EYE, DVec3::ZERO)))
}

fn at_the_eye() -> Camera<'static> {
    let basis = Basis {
        e: EYE,
        u: DVec3::X,
        v: DVec3::Y,
        w: DVec3::Z,
    };
    Camera::Perspective {
        basis,
        half_tangent: 1.0,
    }
}

fn ray(origin: DVec3, towards: DVec3) -> Ray {
    let direction = (towards - origin).normalize();
    Ray { origin, direction }
}

/// Rays from everywhere in the cube to everywhere, or all from the eye.
fn rays(from_eye: bool) -> Vec<Ray> {
    let ray = |i| {
        let [a, b, c, x, y, z] = numbers(2, i);
        let origin = if from_eye { EYE } else { DVec3::new(a, b, c) };
        ray(origin, DVec3::new(x, y, z))
    };
    (0..RAYS).map(ray).collect()
}

/// A sphere as a shape of a type that the engine does not know, so that it is tested for
/// every ray.
fn unknown(sphere: Sphere) -> Shape<'static> {
    Shape::other(move |ray, within| {
        let f = ray.origin - sphere.center;
        let middle = -f.dot(ray.direction);
        let beside = f + ray.direction * middle;
        let discriminant = sphere.radius * sphere.radius - beside.dot(beside);
        if discriminant < 0.0 {
            return None;
        }
        let half = discriminant.sqrt();
        let both = [middle - half, middle + half];
        let t = both.into_iter().find(|t| within.contains(*t))?;
        Some(Hit::new(t, (f + ray.direction * t) / sphere.radius))
    })
}

fn nearest(bencher: Bencher, renderer: &Renderer, rays: &[Ray]) {
    let is_hit = |ray: &&Ray| renderer.hit(ray, Interval::AHEAD).is_some();
    // The tree is built for the first ray, which is not the rays' time.
    let _ = rays.first().as_ref().map(is_hit);
    bencher
        .counter(ItemsCount::new(rays.len()))
        .bench_local(|| rays.iter().filter(is_hit).count());
}

#[divan::bench(args = COUNTS[..3].iter().copied(), sample_count = 5)]
fn list(bencher: Bencher, count: usize) {
    let renderer = prepare(spheres(count).map(unknown), anywhere());
    nearest(bencher, &renderer, &rays(false));
}

#[divan::bench(args = COUNTS, sample_count = 10)]
fn prepared(bencher: Bencher, count: usize) {
    let renderer = prepare(spheres(count).map(Shape::Sphere), anywhere());
    nearest(bencher, &renderer, &rays(false));
}

#[divan::bench(args = COUNTS, sample_count = 10)]
fn prepared_for_the_eye(bencher: Bencher, count: usize) {
    let renderer = prepare(spheres(count).map(Shape::Sphere), at_the_eye());
    nearest(bencher, &renderer, &rays(true));
}

/// The scene, the grid of the eye, and the tree, which is built for the first ray that
/// comes from elsewhere.
#[divan::bench(args = COUNTS, sample_count = 3)]
fn build(bencher: Bencher, count: usize) {
    let elsewhere = ray(DVec3::ZERO, DVec3::Z);
    bencher.counter(ItemsCount::new(count)).bench_local(|| {
        let renderer = prepare(spheres(count).map(Shape::Sphere), at_the_eye());
        renderer.hit(&elsewhere, Interval::AHEAD).is_some()
    });
}
