//! How time and memory grow with the number of objects.
//!
//! ```console
//! $ cargo bench -p a07-transforms --bench scaling
//! ```
//!
//! From ten spheres in a cube to a million, which fill a ninth of it. 65,536 rays
//! ask for the nearest: in the plain list, as far as one can wait for it; in the
//! prepared world as reflected rays do; and as those of the eye do. What `build`
//! allocates at most, divided by its number, is the memory of an object.

use divan::counter::ItemsCount;
use divan::{AllocProfiler, Bencher};

use a02_math::{Point3, Vector3};
use a03_rays_cameras::{Focus, PixelRandom, Ray};
use a04_intersections::{Interval, Sphere, World};
use common::Color;

#[global_allocator]
static ALLOCATOR: AllocProfiler = AllocProfiler::system();

fn main() {
    divan::main();
}

const COUNTS: [usize; 6] = [10, 100, 1_000, 10_000, 100_000, 1_000_000];
const RAYS: u32 = 65_536;
const EYE: Point3 = Point3::new(0.0, 2.0, 5.0);

/// Six numbers from -1 to 1 that belong to `i`; spheres and rays have others.
fn numbers(seed: u64, i: u32) -> [f64; 6] {
    let random = PixelRandom::new(seed, i, 0);
    std::array::from_fn(|n| 2.0 * random.uniform(n as u64) - 1.0)
}

fn world(count: usize) -> World<()> {
    // Spheres as dense as before, however many: a ray passes by a few of them
    // until it meets one.
    let radius = 0.6 / libm::cbrt(count as f64);
    let empty = World::new(Color::BLACK).unwrap();
    (0..count as u32).fold(empty, |world, i| {
        let [x, y, z, ..] = numbers(1, i);
        world.with(Sphere::new(Point3::new(x, y, z), radius).unwrap(), ())
    })
}

/// Rays from everywhere in the cube to everywhere, or all from the eye.
fn rays(from_eye: bool) -> Vec<Ray> {
    let ray = |i| {
        let [a, b, c, x, y, z] = numbers(2, i);
        let origin = if from_eye { EYE } else { Point3::new(a, b, c) };
        Ray::new(origin, Point3::new(x, y, z) - origin).unwrap()
    };
    (0..RAYS).map(ray).collect()
}

fn nearest(bencher: Bencher, world: &World<()>, rays: &[Ray]) {
    let is_hit = |ray: &&Ray| world.hit(ray, Interval::AHEAD).is_some();
    // What is built at the first ray is not the rays' time.
    let _ = rays.first().as_ref().map(is_hit);
    bencher
        .counter(ItemsCount::new(rays.len()))
        .bench_local(|| rays.iter().filter(is_hit).count());
}

#[divan::bench(args = COUNTS[..3].iter().copied(), sample_count = 5)]
fn list(bencher: Bencher, count: usize) {
    nearest(bencher, &world(count), &rays(false));
}

#[divan::bench(args = COUNTS, sample_count = 10)]
fn prepared(bencher: Bencher, count: usize) {
    nearest(bencher, &world(count).prepared([]), &rays(false));
}

#[divan::bench(args = COUNTS, sample_count = 10)]
fn prepared_for_the_eye(bencher: Bencher, count: usize) {
    let world = world(count).prepared([Focus::Point(EYE)]);
    nearest(bencher, &world, &rays(true));
}

/// The world, the cells of the eye, and the trees, which wait for a ray that
/// comes from elsewhere.
#[divan::bench(args = COUNTS, sample_count = 3)]
fn build(bencher: Bencher, count: usize) {
    let elsewhere = Ray::new(Point3::ORIGIN, Vector3::new(0.0, 0.0, 1.0)).unwrap();
    bencher.counter(ItemsCount::new(count)).bench_local(|| {
        let world = world(count).prepared([Focus::Point(EYE)]);
        world.hit(&elsewhere, Interval::AHEAD).is_some()
    });
}
