//! Reports intersection tests and the nearest hit, by a wrapper around each geometry.

use std::any::Any;

use a02_math::arrays::array;
use a03_rays_cameras::Ray;
use common::Color;
use common::steps::{self, Outcome, Step, StepKind, type_name};

use crate::from_file::Mesh;
use crate::instruments::objects;
use crate::{Geometry, Hit, Interval, World};

const WORLD: &str = "a04-intersections.md#hit-and-world";

/// A geometry whose tests are reported.
#[derive(Debug)]
struct RecordedGeometry {
    geometry: Box<dyn Geometry>,
    /// The number of tests for a ray: of each triangle of a mesh, otherwise one.
    tests: u64,
    number: usize,
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
    Box::new(RecordedGeometry {
        name: objects::name(number, &*geometry),
        geometry: inner(geometry),
        tests,
        number,
        section,
    })
}

impl Geometry for RecordedGeometry {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let step = |kind| steps::untraced(|| self.step(kind, ray, within));
        steps::inside(StepKind::Test, self.tests, step, || {
            self.geometry.hit(ray, within)
        })
    }
}

impl RecordedGeometry {
    /// The step of a test. A ray without a hit gets the `t` that the geometry gives for the whole
    /// ray, or else for the whole line.
    fn step(&self, kind: StepKind, ray: &Ray, within: Interval) -> Step {
        let line = Interval {
            min: f64::NEG_INFINITY,
            ..Interval::AHEAD
        };
        let mut step = Step::new(kind, &*self.name, self.section).numbered(self.number);
        step.outcome = Outcome::Missed;
        for (interval, outcome) in [
            (within, Outcome::Hit),
            (Interval::AHEAD, Outcome::BeyondInterval),
            (line, Outcome::BehindOrigin),
        ] {
            if let Some(hit) = self.geometry.hit(ray, interval) {
                step.outcome = outcome;
                return step.with("t", [hit.t]);
            }
        }
        step
    }
}

/// Reports the nearest hit and the steps of `shade`, which computes its colour.
pub fn shaded<T>(ray: &Ray, hit: &Hit, shade: impl FnOnce() -> T) -> T {
    let step = |kind| {
        Step::new(kind, "the nearest hit", WORLD)
            .with("t", [hit.t])
            .with("p", array(ray.at(hit.t)))
            .with("n", array(hit.normal))
            .with("face", array(hit.face))
    };
    steps::inside(StepKind::Hit, 1, step, shade)
}

/// Reports the background if the last ray has hit nothing.
pub fn push_background(background: Color) {
    let is_ray_or_hit = |kind: &StepKind| {
        [StepKind::CameraRay, StepKind::ReflectedRay, StepKind::Hit].contains(kind)
    };
    let last = steps::so_far(|steps| {
        let mut kinds = steps.iter().rev().map(|step| step.kind);
        kinds.find(is_ray_or_hit)
    });
    if let Some(Some(StepKind::CameraRay | StepKind::ReflectedRay)) = last {
        push_color(StepKind::Background, "no hit: the background", background);
    }
}

/// Reports the colour of an object or of the background.
pub fn push_color(kind: StepKind, name: &str, color: Color) {
    steps::push(kind, |kind| {
        Step::new(kind, name, WORLD).with("c", color.channels())
    });
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
