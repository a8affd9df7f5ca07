//! How build time and time per ray grow with the number of objects.
//!
//! ```console
//! $ cargo bench -p engine --bench scaling             a table
//! $ cargo bench -p engine --bench scaling -- --book   and the plot of the book
//! ```
//!
//! From ten spheres in a cube to a million, which fill a ninth of it. Times in
//! nanoseconds: building the scene with its tree, divided by the number of objects; the
//! nearest hit of a ray from the eye, alone and as a pixel of a picture of 1280x960, and of a
//! ray from anywhere to anywhere, as reflected ones are; and the same in a plain list, up to
//! a thousand objects. The least of several rounds counts.

#[path = "../src/adaptive/random.rs"]
mod random;

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use clap::Parser;
use common::{Color, Settings, Size};
use engine::{
    Basis, Camera, Hit, Interval, Ray, Renderer, Sampler, Scene, Shading, Shape, Sphere, Surface,
};
use glam::DVec3;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Point, Unit};
use measure::report::Measured;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::random::PixelRandom;

const COUNTS: [usize; 6] = [10, 100, 1_000, 10_000, 100_000, 1_000_000];
/// Longer lists take too long.
const LONGEST_LIST: usize = 1_000;
const RAYS: u32 = 65_536;
const EYE: DVec3 = DVec3::new(0.0, 2.0, 5.0);

const NAMES: [&str; 5] = [
    "building, an object",
    "a pixel of a picture",
    "a ray from the eye",
    "a ray from anywhere",
    "a ray through a list",
];

/// Measures how time grows with the number of objects.
#[derive(Parser)]
struct Options {
    /// How often everything is measured; the shortest time counts.
    #[arg(long, default_value_t = 5)]
    rounds: u32,
    /// Threads that build; rays are always followed on one.
    #[arg(long, default_value_t = 1)]
    threads: usize,
    /// Renew the plot of the book.
    #[arg(long)]
    book: bool,
    /// Given by `cargo bench`, but not by `cargo test`, which is to measure nothing.
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse();
    if !options.bench {
        return Ok(());
    }
    let threads = |count| ThreadPoolBuilder::new().num_threads(count).build();
    let (builders, one) = (threads(options.threads)?, threads(1)?);
    let mut least = [[f64::INFINITY; NAMES.len()]; COUNTS.len()];
    for _ in 0..options.rounds {
        for (count, least) in COUNTS.into_iter().zip(&mut least) {
            for (now, least) in nanoseconds(count, [&builders, &one])?
                .into_iter()
                .zip(least)
            {
                *least = least.min(now);
            }
        }
    }
    print(&least);
    if options.book {
        plot(&experiment(&least))?;
    }
    Ok(())
}

/// A figure for each of [`NAMES`]; infinite if it is not measured.
fn nanoseconds(
    count: usize,
    [builders, one]: [&ThreadPool; 2],
) -> Result<[f64; NAMES.len()], common::Error> {
    let (renderer, build) = builders.install(|| {
        let started = Instant::now();
        let renderer = prepare(spheres(count).map(Shape::Sphere));
        (renderer, since(started) / count as f64)
    });

    let pixel = one.install(|| picture(&renderer))?;
    let (from_eye, anywhere) = (rays(true), rays(false));
    let [from_eye_time, anywhere_time] =
        [from_eye, anywhere.clone()].map(|rays| hit(&renderer, &rays));
    let list = match count {
        ..=LONGEST_LIST => hit(&prepare(spheres(count).map(unknown)), &anywhere),
        _ => f64::INFINITY,
    };
    Ok([build, pixel, from_eye_time, anywhere_time, list])
}

/// The time of each pixel of a picture.
fn picture(renderer: &Renderer) -> Result<f64, common::Error> {
    let settings = Settings {
        size: Size::new(1280, 960)?,
        ..Settings::default()
    };
    let started = Instant::now();
    black_box(renderer.render(&Middle, &settings, &())?);
    Ok(since(started) / settings.size.pixels() as f64)
}

/// One sample in the middle of each pixel.
struct Middle;

impl Sampler for Middle {
    fn samples(&self) -> u32 {
        1
    }

    fn place(&self, _: u32, _: u32, _: u32) -> (f64, f64) {
        (0.5, 0.5)
    }
}

fn since(started: Instant) -> f64 {
    1e9 * started.elapsed().as_secs_f64()
}

/// The time of each of these rays.
fn hit(renderer: &Renderer, rays: &[Ray]) -> f64 {
    let is_hit = |ray: &&Ray| renderer.hit(ray, Interval::AHEAD).is_some();
    // Caches as in the middle of a picture.
    black_box(rays.iter().filter(is_hit).count());
    let started = Instant::now();
    black_box(rays.iter().filter(is_hit).count());
    since(started) / rays.len() as f64
}

fn print(least: &[[f64; NAMES.len()]]) {
    println!("| objects | {} |", NAMES.join(" | "));
    println!("|---:|{}", "---:|".repeat(NAMES.len()));
    for (count, least) in COUNTS.iter().zip(least) {
        let cell = |ns: f64| {
            if ns.is_finite() {
                format!("{ns:.0}")
            } else {
                String::new()
            }
        };
        println!("| {count} | {} |", least.map(cell).join(" | "));
    }
}

/// Writes the plot of the book.
fn plot(experiment: &Experiment) -> Result<(), Box<dyn Error>> {
    let written = Path::new(env!("CARGO_TARGET_TMPDIR"));
    Measured::new(experiment, Effort::Quick, |_, _| {}).write(written, "engine")?;
    let pictures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/pictures");
    let plot = "engine-scaling.svg";
    fs::copy(written.join(plot), pictures.join(plot))?;
    Ok(())
}

/// The figures as curves, for a plot.
fn experiment(least: &[[f64; NAMES.len()]]) -> Experiment<'_> {
    let curve = move |i: usize| {
        let figures = COUNTS
            .iter()
            .zip(least)
            .map(move |(count, least)| (*count, least[i]));
        let measured = figures.filter(|(_, ns)| ns.is_finite());
        Curve {
            method: NAMES[i],
            remark: "",
            slope: None,
            bound: None,
            points: measured
                .map(|(count, ns)| Point::new(count as f64, 1.0, [ns], || 0.0))
                .collect(),
        }
    };
    Experiment {
        name: "scaling",
        about: "How times grow with the number of objects",
        knob: "objects",
        work: "measurements",
        error: "time",
        unit: Unit::Other("nanoseconds"),
        exact: "the least of several rounds",
        seeds: &[1, 2],
        against: Axis::Knob,
        curves: Box::new(move |_| (0..NAMES.len()).map(curve).collect()),
    }
}

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

/// The shapes, which fill a picture from the eye.
fn prepare(shapes: impl Iterator<Item = Shape<'static>>) -> Renderer<'static> {
    let mut scene = Scene::new(Color::BLACK, Color::BLACK, 1);
    let surface = scene.add_surface(Surface::matt(Shading::SingleColor(Color::WHITE)));
    for shape in shapes {
        scene.add_shape(shape, surface);
    }
    let (u, w) = (DVec3::X, EYE.normalize());
    let camera = Camera::Perspective {
        basis: Basis {
            e: EYE,
            u,
            v: w.cross(u),
            w,
        },
        half_tangent: 0.25,
    };
    Renderer::new(scene, camera, &Settings::default())
}

/// Rays from everywhere in the cube to everywhere, or all from the eye.
fn rays(from_eye: bool) -> Vec<Ray> {
    let ray = |i| {
        let [a, b, c, x, y, z] = numbers(2, i);
        let origin = if from_eye { EYE } else { DVec3::new(a, b, c) };
        Ray {
            origin,
            direction: (DVec3::new(x, y, z) - origin).normalize(),
        }
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
