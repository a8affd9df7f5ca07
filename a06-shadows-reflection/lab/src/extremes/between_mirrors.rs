//! The light between two mirrors that face each other.
//!
//! Each mirror emits 1 and has the reflectance k. After D mirrors a ray has brought back
//! 1 + k + ... + k^(D-1) = (1 - k^D) / (1 - k).

use a02_lab::exact::DoubleDouble;
use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::kinds::KINDS as SHAPES;
use a04_lab::support::Numbers;
use a05_lighting::{DirectionalLight, SingleColor, instruments::recorded};
use common::steps::{self, StepKind};
use common::{Color, Error};
use measure::extremes::{Absolute, Case, Fails, Holds, Id, Known, Number, Outcome, Without, tried};

use crate::mirrors::{Mirrors, UP, level};
use crate::protocol::{self, OneCounter};
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld};

/// Upwards from between the mirrors.
const RAY: Ray = Ray::derived(Point3::new(0.0, 0.0, 0.0), UP);

/// The light after a thousand mirrors of the reflectance 0.99.
const SUM_OF_1000: f64 = 99.995_682_875_258_85;

/// Mirrors 1 apart with a reflectance.
fn reflecting(reflectance: f64) -> Mirrors {
    Mirrors {
        reflectance,
        ..Mirrors::default()
    }
}

/// Mirrors of the reflectance 0.99 at a distance.
fn apart(gap: f64) -> Mirrors {
    Mirrors {
        gap,
        reflectance: 0.99,
        ..Mirrors::default()
    }
}

/// Mirrors of the reflectance 1/2 before a background.
fn before(background: f64) -> Mirrors {
    Mirrors {
        background,
        ..Mirrors::default()
    }
}

/// The light that a ray brings back from this number of mirrors.
fn ours(mirrors: Mirrors, depth: u32) -> Outcome {
    tried(|| {
        let world = mirrors.world()?;
        Ok(RecursiveTracer::new(&world).trace(&RAY, depth).r)
    })
}

/// The last of some pixels by one tracer of the protocol, which all show one mirror.
fn theirs(mirrors: Mirrors, recursion: u32, pixels: usize) -> Outcome {
    tried(|| {
        let world = mirrors.world()?;
        let mut tracer = OneCounter {
            world: &world,
            recursion,
        };
        let mut last = None;
        for _ in 0..pixels {
            last = Some(tracer.trace(&RAY).r);
        }
        Ok(last)
    })
}

/// The light from between mirrors, against its closed form.
fn traced(id: Id, mirrors: Mirrors, depth: u32, exact: f64) -> Case {
    let (gap, k) = (mirrors.gap, mirrors.reflectance);
    // Each mirror rounds a product and a sum, and the next mirrors weaken the errors by k.
    let steps = f64::from(depth).min(1.0 / (1.0 - k));
    Case {
        id,
        what: format!("two mirrors {gap:e} apart, k = {k}, {depth} of them met"),
        exact: Number(exact),
        bound: Absolute(steps * f64::EPSILON * exact),
        condition: Known(condition_of_sum(k, depth)),
        ours: ours(mirrors, depth),
        certified: (k != 1.0).then(|| Number(geometric_sum(k, depth))),
        ..Case::default()
    }
}

/// `(1 - k^depth) / (1 - k)`, with 30 digits in between.
fn geometric_sum(k: f64, depth: u32) -> f64 {
    let (one, k) = (DoubleDouble::from(1.0), DoubleDouble::from(k));
    ((one - k.power(depth.into())) / (one - k)).value()
}

/// The condition of `1 + k + ... + k^(depth-1)`: 1 for the colour of the mirrors, and for k the mean of the
/// exponents, each weighted with its power.
fn condition_of_sum(k: f64, depth: u32) -> f64 {
    let (mut sum, mut weighted, mut power) = (0.0, 0.0, 1.0);
    for exponent in 0..depth {
        sum += power;
        weighted += f64::from(exponent) * power;
        power *= k;
    }
    1.0 + weighted / sum
}

/// The same, where the protocol's tracer is compared, too.
fn compared(id: Id, mirrors: Mirrors, depth: u32, exact: f64) -> Case {
    Case {
        theirs: Some(theirs(mirrors, depth, 1)),
        ..traced(id, mirrors, depth, exact)
    }
}

/// How often a world of two mirrors is searched for the hit of a ray. One search finds the hit, and
/// tests both mirrors. A surface that does not mirror, or is the last, needs no reflected ray.
fn searches(id: Id, what: &str, mirrors: Mirrors, depth: u32) -> Case {
    let count = |trace: fn(&ShadowedWorld, u32) -> Color| {
        tried(|| {
            let world = mirrors.world()?;
            let world = recorded::world(world, SHAPES, |surface| surface, |(_, light)| light);
            let (_, counts) = steps::counted(|| trace(&world, depth))?;
            Ok(counts[StepKind::Test] as f64 / 2.0)
        })
    };
    let ours = count(|world, depth| RecursiveTracer::new(world).trace(&RAY, depth));
    let theirs = count(|world, recursion| OneCounter { world, recursion }.trace(&RAY));
    Case {
        id,
        what: format!("two mirrors, {what}, depth {depth}: searches of the world"),
        exact: Number(1.0),
        condition: Without("a count"),
        protocol: Fails,
        ..Case::of(ours, theirs)
    }
}

/// A mirror without a colour of its own, k = 1/2, under a ceiling of colour 1 that needs no
/// light: it brings back 1/2 for any number of lights.
fn under_lights(id: Id, lights: usize) -> Case {
    let theirs = protocol::reflection_inside_sum(&vec![0.0; lights], 0.5, 1.0);
    Case {
        id,
        what: format!("half of what a mirror sees, under {lights} lights"),
        exact: Number(0.5),
        // A product of the mirror's reflectance and the ceiling's colour.
        condition: Known(2.0),
        protocol: Fails,
        ..Case::of(under_a_ceiling(lights), theirs)
    }
}

/// The light that half a mirror brings back from a white ceiling.
fn under_a_ceiling(lights: usize) -> Result<f64, Error> {
    let mirror = Reflective::new(Color::BLACK, Color::BLACK, 1.0, Color::gray(0.5))?;
    let mut world = ShadowedWorld::empty(Color::BLACK, Color::WHITE)?
        .with(level(0.0)?, Box::new(mirror))
        .with(level(1.0)?, Box::new(SingleColor::new(Color::WHITE)?));
    for _ in 0..lights {
        let light = DirectionalLight::new(Color::WHITE, -UP)?;
        world = world.lit_by(LightSource::new(light, false));
    }
    let ray = Ray::derived(Point3::new(0.0, 0.5, 0.0), -UP);
    Ok(RecursiveTracer::new(&world).trace(&ray, 2).r)
}

/// The length of a direction of length 1 after a million reflections on random normals.
fn length_after_reflections() -> f64 {
    let mut direction = UP;
    for i in 0..1_000_000 {
        let normal = Numbers::new(11, i).triple(-1.0, 1.0).normalized();
        direction = direction.reflected_on(normal.unwrap_or(UP).as_normal());
    }
    direction.dot(direction).sqrt()
}

pub fn cases() -> Vec<Case> {
    let half = reflecting(0.5);
    let mut cases = sums();
    cases.extend([
        traced("M07", half, 1_100, 2.0),
        traced("M08", reflecting(1.0), 1_000_000, 1e6),
        searches("M09", "k = 0", reflecting(0.0), 10),
        searches("M19", "k = 1/2", half, 1),
        traced("M18", reflecting(0.0), 10, 1.0),
        under_lights("M10", 3),
        under_lights("I10", 0),
        Case {
            id: "M11",
            what: "a direction of length 1 after 1e6 reflections: its length".into(),
            exact: Number(1.0),
            condition: Known(1.0),
            bound: Absolute(1e6 * f64::EPSILON),
            ours: length_after_reflections().into(),
            ..Case::default()
        },
        Case {
            id: "M12",
            what: "the second pixel of one tracer of depth 1: the mirror's own colour".into(),
            exact: Number(1.0),
            condition: Known(condition_of_sum(0.5, 1)),
            protocol: Fails,
            ..Case::of(ours(before(0.25), 1), theirs(before(0.25), 1, 2))
        },
        traced("M16", apart(1e-90), 1_000, SUM_OF_1000),
        traced("M17", apart(1e90), 1_000, SUM_OF_1000),
    ]);
    cases
}

/// The light after some mirrors.
fn sums() -> Vec<Case> {
    let half = reflecting(0.5);
    vec![
        Case {
            protocol: Holds,
            ..compared("M01", half, 1, 1.0)
        },
        Case {
            protocol: Holds,
            ..compared("M13", half, 5, 1.9375)
        },
        Case {
            protocol: Holds,
            ..compared("M14", half, 10, 1.998_046_875)
        },
        Case {
            protocol: Holds,
            ..compared("M15", half, 50, 1.999_999_999_999_998_2)
        },
        Case {
            protocol: Holds,
            ..compared("M02", reflecting(0.9), 10, 6.513_215_599_000_000_5)
        },
        traced("M03", reflecting(0.99), 1_000, SUM_OF_1000),
        traced("M04", reflecting(1.0), 1_000, 1_000.0),
        // The last mirror does not reflect the background.
        Case {
            id: "M05",
            what: "two mirrors, k = 1/2, before a background of 8, 3 of them met".into(),
            exact: Number(1.75),
            condition: Known(condition_of_sum(0.5, 3)),
            protocol: Fails,
            ..Case::of(ours(before(8.0), 3), theirs(before(8.0), 3, 1))
        },
        Case {
            protocol: Fails,
            ..compared("M06", apart(0.0005), 1_000, SUM_OF_1000)
        },
    ]
}
