//! The light between two mirrors that face each other.
//!
//! Each emits 1 and has the reflectance k. After D mirrors a ray has brought back
//! 1 + k + ... + k^(D-1) = (1 - k^D) / (1 - k).

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::{PixelRandom, Ray};
use a04_intersections::{Geometry, Hit, Interval, Plane};
use a05_lighting::{DirectionalLight, SingleColor};
use common::{ArgumentError, Color};
use measure::extremes::Protocol::{Fails, Holds};
use measure::extremes::{Bound, Case};

use crate::lab::protocol::{self, OneCounter};
use crate::{LightSource, RecursiveTracer, Reflective, ShadowedWorld};

type Made<T> = Result<T, ArgumentError>;

const UP: Vector3 = Vector3::new(0.0, 1.0, 0.0);

pub fn cases() -> Vec<Case> {
    let series = Mirrors {
        gap: 1.0,
        k: 0.5,
        background: 0.0,
    };
    let tenth = Mirrors { k: 0.9, ..series };
    let hundredth = Mirrors { k: 0.99, ..series };
    let thin = Mirrors {
        gap: 0.0005,
        ..hundredth
    };
    let all = Mirrors { k: 1.0, ..series };
    vec![
        series.row("M01", 1, 1.0).protocol(Holds, series.theirs(1)),
        series
            .row("M13", 5, 1.9375)
            .protocol(Holds, series.theirs(5)),
        series
            .row("M14", 10, 1.998_046_875)
            .protocol(Holds, series.theirs(10)),
        series
            .row("M15", 50, 1.999_999_999_999_998_2)
            .protocol(Holds, series.theirs(50)),
        tenth
            .row("M02", 10, 6.513_215_599_000_000_5)
            .protocol(Holds, tenth.theirs(10)),
        hundredth.row("M03", 1_000, 99.995_682_875_258_85),
        all.row("M04", 1_000, 1_000.0),
        Mirrors {
            background: 8.0,
            ..series
        }
        .at_the_limit("M05"),
        thin.row("M06", 1_000, 99.995_682_875_258_85)
            .protocol(Fails, thin.theirs(1_000)),
        series.row("M07", 1_100, 2.0),
        all.row("M08", 1_000_000, 1e6),
        Mirrors { k: 0.0, ..series }.searches("M09", "two mirrors, k = 0, depth 10", 10),
        series.searches("M19", "two mirrors, k = 1/2, depth 1", 1),
        Mirrors { k: 0.0, ..series }.row("M18", 10, 1.0),
        behind_lights("M10", 3),
        behind_lights("I10", 0),
        million_reflections("M11"),
        Mirrors {
            background: 0.25,
            ..series
        }
        .two_pixels("M12"),
        Mirrors {
            gap: 1e-90,
            ..hundredth
        }
        .row("M16", 1_000, 99.995_682_875_258_85),
        Mirrors {
            gap: 1e90,
            ..hundredth
        }
        .row("M17", 1_000, 99.995_682_875_258_85),
    ]
}

#[derive(Clone, Copy)]
struct Mirrors {
    gap: f64,
    k: f64,
    background: f64,
}

impl Mirrors {
    fn world(self, below: impl Geometry + 'static) -> Made<ShadowedWorld> {
        let mirror = || Reflective::new(Color::WHITE, Color::BLACK, 1.0, Color::gray(self.k));
        let above = plane(self.gap)?;
        Ok(
            ShadowedWorld::empty(Color::gray(self.background), Color::WHITE)?
                .with(below, Box::new(mirror()?))
                .with(above, Box::new(mirror()?)),
        )
    }

    /// The ray from the middle upwards.
    fn ray(self) -> Ray {
        Ray::derived(Point3::new(0.0, self.gap / 2.0, 0.0), UP)
    }

    fn ours(self, depth: u32) -> Made<f64> {
        let world = self.world(plane(0.0)?)?;
        Ok(RecursiveTracer::new(&world).trace(&self.ray(), depth).r)
    }

    fn theirs(self, depth: u32) -> Made<f64> {
        let world = self.world(plane(0.0)?)?;
        let mut tracer = OneCounter {
            world: &world,
            recursion: depth,
        };
        Ok(tracer.trace(&self.ray()).r)
    }

    fn row(self, id: &'static str, depth: u32, exact: f64) -> Case {
        let Self { gap, k, .. } = self;
        let what = format!("two mirrors {gap:e} apart, k = {k}, {depth} of them met");
        let bound = Bound::Absolute(f64::from(depth) * f64::EPSILON * exact);
        Case::new(id, what, exact, bound, self.ours(depth))
    }

    /// The last mirror does not reflect the background.
    fn at_the_limit(self, id: &'static str) -> Case {
        let what = "two mirrors, k = 1/2, before a background of 8, 3 of them met";
        Case::new(id, what, 1.75, Bound::Equal, self.ours(3)).protocol(Fails, self.theirs(3))
    }

    /// Both pixels show one mirror.
    fn two_pixels(self, id: &'static str) -> Case {
        let both = || {
            let world = self.world(plane(0.0)?)?;
            let tracer = RecursiveTracer::new(&world);
            let mut counter = OneCounter {
                world: &world,
                recursion: 1,
            };
            let ours = [0; 2].map(|_| tracer.trace(&self.ray(), 1).r);
            Ok::<_, ArgumentError>((ours, [0; 2].map(|_| counter.trace(&self.ray()).r)))
        };
        let second = |pixels: [f64; 2]| pixels[1];
        let what = "the second pixel of one tracer of depth 1: the mirror's own colour";
        Case::new(
            id,
            what,
            1.0,
            Bound::Equal,
            both().map(|both| second(both.0)),
        )
        .protocol(Fails, both().map(|both| second(both.1)))
    }

    /// One search finds the hit. A surface that does not mirror, or is the last,
    /// needs no reflected ray.
    fn searches(self, id: &'static str, what: &str, depth: u32) -> Case {
        let count = |trace: &dyn Fn(&ShadowedWorld, &Ray) -> Color| {
            let (below, rays) = Counting::new(plane(0.0)?);
            let world = self.world(below)?;
            trace(&world, &self.ray());
            Ok::<_, ArgumentError>(rays.load(Ordering::Relaxed))
        };
        let ours = count(&|world, ray| RecursiveTracer::new(world).trace(ray, depth));
        let theirs = count(&|world, ray| {
            OneCounter {
                world,
                recursion: depth,
            }
            .trace(ray)
        });
        let what = format!("{what}: searches of the world");
        Case::new(id, what, 1.0, Bound::Equal, ours).protocol(Fails, theirs)
    }
}

fn plane(y: f64) -> Made<Plane> {
    Plane::new(Point3::new(0.0, y, 0.0), UP.as_normal())
}

/// A mirror without a colour of its own, k = 1/2, under a ceiling of colour 1
/// that needs no light: it brings back 1/2 for any number of lights.
fn behind_lights(id: &'static str, lights: usize) -> Case {
    let ours = || {
        let mirror = Reflective::new(Color::BLACK, Color::BLACK, 1.0, Color::gray(0.5))?;
        let mut world = ShadowedWorld::empty(Color::BLACK, Color::WHITE)?
            .with(plane(0.0)?, Box::new(mirror))
            .with(plane(1.0)?, Box::new(SingleColor::new(Color::WHITE)?));
        for _ in 0..lights {
            let light = DirectionalLight::new(Color::WHITE, -UP)?;
            world = world.lit_by(LightSource::new(light, false));
        }
        let ray = Ray::derived(Point3::new(0.0, 0.5, 0.0), -UP);
        Ok::<_, ArgumentError>(RecursiveTracer::new(&world).trace(&ray, 2).r)
    };
    let theirs = protocol::reflection_inside_sum(&vec![0.0; lights], 0.5, 1.0);
    let what = format!("half of what a mirror sees, under {lights} lights");
    Case::new(id, what, 0.5, Bound::Equal, ours()).protocol(Fails, theirs)
}

fn million_reflections(id: &'static str) -> Case {
    let mut direction = UP;
    for i in 0..1_000_000 {
        let random = PixelRandom::new(11, i, 0);
        let number = |n| 2.0 * random.uniform(n) - 1.0;
        let normal = Normal3::new(number(0), number(1), number(2)).normalized();
        direction = direction.reflected_on(normal.unwrap_or(UP.as_normal()));
    }
    let bound = Bound::Absolute(1e6 * f64::EPSILON);
    let what = "a direction of length 1 after 1e6 reflections: its length";
    Case::new(id, what, 1.0, bound, direction.dot(direction).sqrt())
}

/// A geometry that counts the rays tested against it.
#[derive(Debug)]
pub struct Counting<G> {
    geometry: G,
    rays: Arc<AtomicUsize>,
}

impl<G> Counting<G> {
    pub fn new(geometry: G) -> (Self, Arc<AtomicUsize>) {
        let rays = Arc::new(AtomicUsize::new(0));
        let counter = Arc::clone(&rays);
        (Self { geometry, rays }, counter)
    }
}

impl<G: Geometry> Geometry for Counting<G> {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.rays.fetch_add(1, Ordering::Relaxed);
        self.geometry.hit(ray, within)
    }
}
