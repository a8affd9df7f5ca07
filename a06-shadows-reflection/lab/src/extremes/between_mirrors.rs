//! The light between two mirrors that face each other.
//!
//! Each mirror emits 1 and has the reflectance k. After D mirrors a ray has brought back
//! 1 + k + ... + k^(D-1) = (1 - k^D) / (1 - k).

use a02_math::Point3;
use a03_rays_cameras::Ray;
use a04_intersections::registry::ALL_SHAPES;
use a05_lighting::{DirectionalLight, SingleColor, instruments::instrumented};
use common::steps::{self, StepKind};
use common::{Color, Error};
use measure::extremes::{Case, Outcome, Row, tried};

use crate::mirrors::{Mirrors, UP, level};
use crate::protocol::{self, OneCounter};
use a06_shadows_reflection::{LightSource, RecursiveTracer, Reflective, ShadowedWorld};

/// Upwards from between the mirrors.
const RAY: Ray = Ray::derived(Point3::new(0.0, 0.0, 0.0), UP);

/// Two mirrors of a row: their distance, reflectance and background.
fn mirrors(row: &Row) -> Mirrors {
    Mirrors {
        gap: row.number(0),
        reflectance: row.number(1),
        background: row.number(2),
    }
}

/// What a row asks: the light after some mirrors, of the last of some pixels by one tracer of the protocol; how often
/// the world is searched; or half of what a mirror sees under some lights.
pub fn computed(row: &Row) -> Case {
    let depth = row.number(3) as u32;
    match row.asks.as_str() {
        "mirrors" => {
            let pixels = row.number(4) as usize;
            let theirs = theirs(mirrors(row), depth, pixels);
            Case::of(ours(mirrors(row), depth), theirs)
        }
        // The protocol's recursion does not end, or takes too long.
        "mirrors, ours" => Case::of_ours(ours(mirrors(row), depth)),
        "searches" => {
            let mirrors = Mirrors {
                reflectance: row.number(0),
                ..Mirrors::default()
            };
            searches(mirrors, row.number(1) as u32)
        }
        _ => under_lights(row.number(0) as usize),
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

/// How often a world of two mirrors is searched for the hit of a ray. One search finds the hit, and
/// tests both mirrors. A surface that does not mirror, or is the last, needs no reflected ray.
fn searches(mirrors: Mirrors, depth: u32) -> Case {
    let count = |trace: fn(&ShadowedWorld, u32) -> Color| {
        tried(|| {
            let world = mirrors.world()?;
            let world =
                instrumented::world(world, ALL_SHAPES, |surface| surface, |(_, light)| light);
            let (_, counts) = steps::counted(|| trace(&world, depth))?;
            Ok(counts[StepKind::Test] as f64 / 2.0)
        })
    };
    let ours = count(|world, depth| RecursiveTracer::new(world).trace(&RAY, depth));
    let theirs = count(|world, recursion| OneCounter { world, recursion }.trace(&RAY));
    Case::of(ours, theirs)
}

/// A mirror without a colour of its own, k = 1/2, under a ceiling of colour 1 that needs no
/// light: it brings back 1/2 for any number of lights.
fn under_lights(lights: usize) -> Case {
    let theirs = protocol::reflection_inside_sum(&vec![0.0; lights], 0.5, 1.0);
    Case::of(under_a_ceiling(lights), theirs)
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
