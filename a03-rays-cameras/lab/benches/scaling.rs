//! How build time and time per ray grow with the number of objects.
//!
//! ```console
//! $ cargo bench -p a03-lab --bench scaling             a table
//! $ cargo bench -p a03-lab --bench scaling -- --book   and the plot of the engine's README
//! ```
//!
//! From ten spheres in a cube to a million, which fill a ninth of it. Times in nanoseconds on
//! one thread, the least of several rounds: building the scene with its tree, divided by the
//! number of objects; a pixel of a picture; a ray from the eye towards any place, and from
//! anywhere to anywhere, as reflected ones are; and the same in a plain list, up to a thousand
//! objects.

mod support;

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use common::{Color, Settings, Size};
use engine::{Camera, Hit, Ray, Renderer, Scene, Shading, Shape, Sphere, Surface};
use glam::DVec3;
use measure::experiment::{Axis, Curve, Errors, Experiment, Point, Times, Unit};
use measure::report::Measured;
use rayon::ThreadPoolBuilder;

use crate::support::{Grid, Numbers, camera, print_head, print_row};

const COUNTS: [u32; 6] = [10, 100, 1_000, 10_000, 100_000, 1_000_000];
/// Width and height of the pictures.
const SIDE: u32 = 512;
const EYE: DVec3 = DVec3::new(0.0, 2.0, 5.0);

const NAMES: [&str; 5] = [
    "building, an object",
    "a pixel of a picture",
    "a ray from the eye",
    "a ray from anywhere",
    "a ray through a list",
];

fn main() -> Result<(), Box<dyn Error>> {
    let is_given = |name: &str| std::env::args().any(|argument| argument == name);
    // Given by `cargo bench`, but not by `cargo test`.
    if !is_given("--bench") {
        return Ok(());
    }
    let mut least = [[f64::NAN; NAMES.len()]; COUNTS.len()];
    let one_thread = ThreadPoolBuilder::new().num_threads(1).build()?;
    for _ in 0..5 {
        for (count, least) in COUNTS.into_iter().zip(&mut least) {
            let now = one_thread.install(|| nanoseconds(count))?;
            *least = std::array::from_fn(|i| least[i].min(now[i]));
        }
    }
    print_head("objects", &NAMES);
    for (count, least) in COUNTS.iter().zip(least) {
        print_row(&count.to_string(), least);
    }
    if is_given("--book") {
        plot(&least)
    } else {
        Ok(())
    }
}

/// A time for each of [`NAMES`]; NaN if it is not measured.
fn nanoseconds(count: u32) -> Result<[f64; NAMES.len()], common::Error> {
    let started = Instant::now();
    let picture = prepare(spheres(count).map(known), camera(EYE, -EYE, 0.25));
    let building = since(started) / f64::from(count);
    let picture = pixel(&picture)?;
    let from_the_eye = pixel(&prepare(spheres(count).map(known), rays(true)))?;
    let from_anywhere = pixel(&prepare(spheres(count).map(known), rays(false)))?;
    let through_a_list = if count <= 1_000 {
        pixel(&prepare(spheres(count).map(unknown), rays(false)))?
    } else {
        f64::NAN
    };
    Ok([
        building,
        picture,
        from_the_eye,
        from_anywhere,
        through_a_list,
    ])
}

/// Spheres as dense for any number of them: a ray passes by a few until it hits one.
fn spheres(count: u32) -> impl Iterator<Item = Sphere> {
    let radius = 0.6 / libm::cbrt(count.into());
    (0..count).map(move |i| Sphere {
        center: Numbers::new(1, i).in_cube(1.0),
        radius,
    })
}

fn since(started: Instant) -> f64 {
    1e9 * started.elapsed().as_secs_f64()
}

/// The time of each pixel, with caches as in the middle of a picture.
fn pixel(renderer: &Renderer) -> Result<f64, common::Error> {
    let settings = Settings {
        size: Size::new(SIDE, SIDE)?,
        ..Settings::default()
    };
    black_box(renderer.render(&Grid::ONE, &settings, &())?);
    let started = Instant::now();
    black_box(renderer.render(&Grid::ONE, &settings, &())?);
    Ok(since(started) / settings.size.pixels() as f64)
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

/// A camera of rays from everywhere in the cube to everywhere, or all from the eye.
fn rays(from_eye: bool) -> Camera<'static> {
    let mut rays = Vec::new();
    for i in 0..SIDE * SIDE {
        let mut numbers = Numbers::new(2, i);
        let (anywhere, target) = (numbers.in_cube(1.0), numbers.in_cube(1.0));
        let origin = if from_eye { EYE } else { anywhere };
        let direction = (target - origin).normalize();
        rays.push(Ray { origin, direction });
    }
    Camera::Other(Box::new(move |_, x, y| {
        rays[y as usize * SIDE as usize + x as usize]
    }))
}

fn known(sphere: Sphere) -> Shape<'static> {
    Shape::Sphere(sphere)
}

/// A sphere as a shape of a type that the engine does not know, so that it is tested for
/// every ray.
fn unknown(Sphere { center, radius }: Sphere) -> Shape<'static> {
    Shape::other(move |ray| {
        let f = ray.origin - center;
        let middle = -f.dot(ray.direction);
        let beside = f + ray.direction * middle;
        // Beside the sphere the root is NaN, which is not above 0.
        let half = (radius * radius - beside.length_squared()).sqrt();
        let mut roots = [middle - half, middle + half].into_iter();
        let t = roots.find(|t| *t > 0.0)?;
        Some(Hit::new(t, (f + ray.direction * t) / radius))
    })
}

/// Writes the plot of the book.
fn plot(least: &[[f64; NAMES.len()]]) -> Result<(), Box<dyn Error>> {
    let curve = |i: usize| {
        let mut points = Vec::new();
        for (count, least) in COUNTS.iter().zip(least) {
            if least[i] > 0.0 {
                points.push(Point {
                    parameter: (*count).into(),
                    work: 1.0,
                    errors: Errors::of([least[i]]),
                    times: Times::of(|| ()),
                });
            }
        }
        Curve::new(NAMES[i], points)
    };
    let experiment = Experiment {
        question: "How times grow with the number of objects",
        parameter: "objects",
        work: "measurements",
        against: Axis::Parameter,
        error: "time",
        unit: Unit::Other("nanoseconds"),
        exact: "the least of several rounds",
        seeds: &[1, 2],
        curves: Box::new(|| (0..NAMES.len()).map(curve).collect()),
        ..Experiment::new("scaling")
    };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    Measured::new(experiment, 1, |_, _| {}).write_plots(folder, "engine", None)?;
    let plot = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../common/engine/scaling.svg");
    fs::copy(folder.join("engine-scaling.svg"), plot)?;
    Ok(())
}
