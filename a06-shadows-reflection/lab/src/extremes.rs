//! The stiff and extreme cases of this stage: self-hits, shadows, and the light between two
//! mirrors that face each other.
//!
//! Each mirror emits 1 and has the reflectance k. After D mirrors a ray has brought back
//! 1 + k + ... + k^(D-1) = (1 - k^D) / (1 - k).

mod shadows;

use a02_lab::exact::DoubleDouble;
use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::Plane;
use a04_intersections::kinds::KINDS as SHAPES;
use a04_lab::support::Numbers;
use a05_lighting::{DirectionalLight, SingleColor, instruments::recorded};
use common::steps::{self, StepKind};
use common::{ArgumentError, Color, Error};
use measure::Effort;
use measure::extremes::{Absolute, Case, Equal, Fails, Holds, tried};

use crate::protocol::{self, OneCounter};
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld};

pub fn cases(effort: Effort) -> Vec<Case> {
    let shadows = shadows::cases(effort);
    [shadows, in_mirrors()].concat()
}

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);
/// Upwards from between the mirrors.
const RAY: Ray = Ray::derived(Point3::new(0.0, 0.0, 0.0), UP);

/// The distance of two mirrors, their reflectance k, and the background.
type Mirrors = (f64, f64, f64);

/// Two mirrors at equal distances below and above the origin.
pub fn mirrors((gap, k, background): Mirrors) -> Result<ShadowedWorld, Error> {
    let empty = ShadowedWorld::empty(Color::gray(background), Color::WHITE)?;
    [-0.5, 0.5].into_iter().try_fold(empty, |world, side| {
        let mirror = Reflective::new(Color::WHITE, Color::BLACK, 1.0, Color::gray(k))?;
        Ok(world.with(plane(side * gap)?, Box::new(mirror)))
    })
}

fn plane(y: f64) -> Result<Plane, ArgumentError> {
    Plane::new(Point3::new(0.0, y, 0.0), UP.as_normal())
}

/// The light that half a mirror brings back from a white ceiling.
fn under_a_ceiling(lights: usize) -> Result<f64, Error> {
    let mirror = Reflective::new(Color::BLACK, Color::BLACK, 1.0, Color::gray(0.5))?;
    let mut world = ShadowedWorld::empty(Color::BLACK, Color::WHITE)?
        .with(plane(0.0)?, Box::new(mirror))
        .with(plane(1.0)?, Box::new(SingleColor::new(Color::WHITE)?));
    for _ in 0..lights {
        let light = DirectionalLight::new(Color::WHITE, -UP)?;
        world = world.lit_by(LightSource::new(light, false));
    }
    let ray = Ray::derived(Point3::new(0.0, 0.5, 0.0), -UP);
    Ok(RecursiveTracer::new(&world).trace(&ray, 2).r)
}

#[rustfmt::skip]
fn in_mirrors() -> Vec<Case> {
    const SUM_OF_1000: f64 = 99.995_682_875_258_85;
    let [none, half, tenth, hundredth, all] = [0.0, 0.5, 0.9, 0.99, 1.0].map(|k| (1.0, k, 0.0));
    let apart = |gap: f64| (gap, 0.99, 0.0);
    let before = |background: f64| (1.0, 0.5, background);
    let ours = |two: Mirrors, depth| mirrors(two).map(|world| RecursiveTracer::new(&world).trace(&RAY, depth).r);
    // The last of some pixels by the protocol's tracer, which all show one mirror.
    let theirs = |two: Mirrors, recursion, pixels: usize| mirrors(two).map(|world| {
        let mut tracer = OneCounter { world: &world, recursion };
        (0..pixels).map(|_| tracer.trace(&RAY).r).last()
    });
    let row = |id, two: Mirrors, depth: u32, exact: f64| {
        let what = format!("two mirrors {:e} apart, k = {}, {depth} of them met", two.0, two.1);
        let bound = Absolute(f64::from(depth) * f64::EPSILON * exact);
        let [one, k] = [1.0, two.1].map(DoubleDouble::from);
        let sum = || ((one - k.power(depth.into())) / (one - k)).value();
        Case::new(id, what, exact, bound, ours(two, depth)).certified((k != one).then(sum))
    };
    // One search finds the hit, and tests both mirrors. A surface that does not mirror, or is
    // the last, needs no reflected ray.
    let searches = |id, what: &str, two: Mirrors, depth: u32| {
        let count = |trace: fn(&ShadowedWorld, u32) -> Color| tried(|| {
            let world = recorded::world(mirrors(two)?, SHAPES, |surface| surface, |(_, light)| light);
            let (_, counts) = steps::counted(|| trace(&world, depth))?;
            Ok(counts[StepKind::Test] as f64 / 2.0)
        });
        let ours = count(|world, depth| RecursiveTracer::new(world).trace(&RAY, depth));
        let theirs = count(|world, recursion| OneCounter { world, recursion }.trace(&RAY));
        let what = format!("two mirrors, {what}, depth {depth}: searches of the world");
        Case::new(id, what, 1.0, Equal, ours).protocol(Fails, theirs)
    };
    // A mirror without a colour of its own, k = 1/2, under a ceiling of colour 1 that needs no
    // light: it brings back 1/2 for any number of lights.
    let behind_lights = |id, lights: usize| {
        let theirs = protocol::reflection_inside_sum(&vec![0.0; lights], 0.5, 1.0);
        let what = format!("half of what a mirror sees, under {lights} lights");
        Case::new(id, what, 0.5, Equal, under_a_ceiling(lights)).protocol(Fails, theirs)
    };
    let reflected = (0..1_000_000).fold(UP, |direction, i| {
        let normal = Numbers::new(11, i).triple(-1.0, 1.0).normalized();
        direction.reflected_on(normal.unwrap_or(UP).as_normal())
    });
    vec![
        row("M01", half, 1, 1.0).protocol(Holds, theirs(half, 1, 1)),
        row("M13", half, 5, 1.9375).protocol(Holds, theirs(half, 5, 1)),
        row("M14", half, 10, 1.998_046_875).protocol(Holds, theirs(half, 10, 1)),
        row("M15", half, 50, 1.999_999_999_999_998_2).protocol(Holds, theirs(half, 50, 1)),
        row("M02", tenth, 10, 6.513_215_599_000_000_5).protocol(Holds, theirs(tenth, 10, 1)),
        row("M03", hundredth, 1_000, SUM_OF_1000),
        row("M04", all, 1_000, 1_000.0),
        // The last mirror does not reflect the background.
        Case::new("M05", "two mirrors, k = 1/2, before a background of 8, 3 of them met",
            1.75, Equal, ours(before(8.0), 3)).protocol(Fails, theirs(before(8.0), 3, 1)),
        row("M06", apart(0.0005), 1_000, SUM_OF_1000).protocol(Fails, theirs(apart(0.0005), 1_000, 1)),
        row("M07", half, 1_100, 2.0),
        row("M08", all, 1_000_000, 1e6),
        searches("M09", "k = 0", none, 10),
        searches("M19", "k = 1/2", half, 1),
        row("M18", none, 10, 1.0),
        behind_lights("M10", 3),
        behind_lights("I10", 0),
        Case::new("M11", "a direction of length 1 after 1e6 reflections: its length",
            1.0, Absolute(1e6 * f64::EPSILON), reflected.dot(reflected).sqrt()),
        Case::new("M12", "the second pixel of one tracer of depth 1: the mirror's own colour",
            1.0, Equal, ours(before(0.25), 1)).protocol(Fails, theirs(before(0.25), 1, 2)),
        row("M16", apart(1e-90), 1_000, SUM_OF_1000),
        row("M17", apart(1e90), 1_000, SUM_OF_1000),
    ]
}
