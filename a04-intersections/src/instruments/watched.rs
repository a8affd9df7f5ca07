//! Counts and records intersection tests, by a wrapper around each geometry.

use a02_math::arrays::array;
use std::any::Any;

use a03_rays_cameras::Ray;
use common::Color;
use common::steps::{self, HIT, NO_HIT, RAY, REFLECTED, Step, TEST, type_name};
use common::tally::{self, Work};

use crate::from_file::Mesh;
use crate::instruments::objects;
use crate::{Geometry, Hit, Interval, World};

const WORLD: &str = "a04-intersections.md#hit-and-world";

/// A geometry whose tests are counted and recorded.
#[derive(Debug)]
struct Watched {
    geometry: Box<dyn Geometry>,
    /// The number of tests for a ray: of each triangle of a mesh, otherwise one.
    tests: u64,
    name: String,
    section: &'static str,
}

/// Wraps a geometry, counted from 1 in its list, and before that by `inner`.
pub fn geometry(
    number: usize,
    geometry: Box<dyn Geometry>,
    inner: impl FnOnce(Box<dyn Geometry>) -> Box<dyn Geometry>,
) -> Box<dyn Geometry> {
    let name = type_name(&geometry);
    let mesh = (&*geometry as &dyn Any).downcast_ref::<Mesh>();
    let tests = mesh.map_or(1, |Mesh(triangles)| triangles.objects.len() as u64);
    let section = match &*name {
        "Plane" => "a04-intersections.md#plane",
        "Sphere" => "a04-intersections.md#sphere",
        "AxisAlignedBox" => "a04-intersections.md#box",
        "Triangle" => "a04-intersections.md#triangle",
        "Disc" => "a07-transforms.md#disc",
        "Node" => "a07-transforms.md#node",
        _ => "a04-intersections.md#one-question-and-an-interval",
    };
    Box::new(Watched {
        name: objects::name(number, &*geometry),
        geometry: inner(geometry),
        tests,
        section,
    })
}

impl Geometry for Watched {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        tally::count_all(Work::IntersectionTest, self.tests);
        let step = || steps::paused(|| self.step(ray, within));
        steps::inside(step, || self.geometry.hit(ray, within))
    }
}

impl Watched {
    /// The step of a test. A ray without a hit gets the `t` that the geometry gives for the whole
    /// ray, or else for the whole line.
    fn step(&self, ray: &Ray, within: Interval) -> Step {
        let line = Interval {
            min: f64::NEG_INFINITY,
            ..Interval::AHEAD
        };
        let intervals = [
            (within, HIT),
            (Interval::AHEAD, "beyond the interval"),
            (line, "behind the origin of the ray"),
        ];
        let found = intervals.into_iter().find_map(|(within, outcome)| {
            let hit = self.geometry.hit(ray, within)?;
            Some((vec![("t", vec![hit.t])], outcome))
        });
        let (values, outcome) = found.unwrap_or((Vec::new(), "beside the ray"));
        Step {
            outcome: outcome.to_owned(),
            values,
            ..Step::new(TEST, &*self.name, self.section)
        }
    }
}

/// Records the nearest hit and the steps of `shade`, which computes its colour.
pub fn shaded<T>(ray: &Ray, hit: &Hit, shade: impl FnOnce() -> T) -> T {
    let step = || {
        Step::new(HIT, "the nearest hit", WORLD)
            .with("t", [hit.t])
            .with("p", array(ray.at(hit.t)))
            .with("n", array(hit.normal))
            .with("face", array(hit.face))
    };
    steps::inside(step, shade)
}

/// Records the background if the last ray has hit nothing.
pub fn push_background(background: Color) {
    let last = |steps: &mut Vec<Step>| {
        let mut kinds = steps.iter().rev().map(|step| step.kind);
        kinds.find(|kind| [RAY, REFLECTED, HIT].contains(kind))
    };
    if steps::so_far(last)
        .flatten()
        .is_some_and(|kind| kind != HIT)
    {
        push_color(NO_HIT, background);
    }
}

/// Records the colour of an object or the background.
pub fn push_color(name: &str, color: Color) {
    steps::push(|| Step::new("color", name, WORLD).with("c", color.channels()));
}

/// The world with its geometries, counted from 1, and surfaces replaced by these functions of
/// them.
pub fn world<S, T>(
    world: World<S>,
    geometry: impl Fn(usize, Box<dyn Geometry>) -> Box<dyn Geometry>,
    surface: impl Fn(S) -> T,
) -> World<T> {
    let objects = (1..).zip(world.objects);
    let objects = objects.map(|(number, (g, s))| (geometry(number, g), surface(s)));
    World {
        background: world.background,
        objects: objects.collect(),
    }
}

/// Wraps a geometry of this stage.
pub fn plain(number: usize, own: Box<dyn Geometry>) -> Box<dyn Geometry> {
    geometry(number, own, |own| own)
}
