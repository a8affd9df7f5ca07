//! Reports intersection tests and the nearest hit, by a wrapper around each geometry.

use std::mem;

use a02_math::arrays::array;
use a03_rays_cameras::Ray;
use common::Color;
use common::steps::{self, Outcome, Step, StepKind, type_name};

use crate::instruments::objects;
use crate::registry::{Content, ShapeKind, ShapeRow, Shapes};
use crate::{Geometry, Hit, Interval, World};

const WORLD: &str = "a04-intersections.md#hit-and-world";
/// The section about shapes whose type has no row.
const ANY_SHAPE: &str = "a04-intersections.md#one-question-and-an-interval";

/// A geometry whose tests are reported.
#[derive(Debug)]
struct InstrumentedGeometry {
    geometry: Box<dyn Geometry>,
    row: Option<&'static ShapeRow>,
    shapes: Shapes,
    /// The number of tests for a ray.
    tests: u64,
    number: usize,
    name: String,
}

/// Wraps a geometry, counted from 1 in its list, and its children.
pub fn geometry(
    number: usize,
    mut geometry: Box<dyn Geometry>,
    shapes: Shapes,
) -> Box<dyn Geometry> {
    let name = objects::name(number, &*geometry);
    let row = shapes.row(&*geometry);
    if let Some(children) = shapes.children_mut(&mut *geometry) {
        let all = (1..).zip(mem::take(children));
        *children = all
            .map(|(i, child)| self::geometry(i, child, shapes))
            .collect();
    }
    let kind = row.and_then(|row| row.get(&*geometry));
    Box::new(InstrumentedGeometry {
        tests: kind.map_or(1, ShapeKind::tests),
        geometry,
        row,
        shapes,
        number,
        name,
    })
}

impl Geometry for InstrumentedGeometry {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.test(ray, within, || self.geometry.hit(ray, within))
    }

    fn any_hit(&self, ray: &Ray, within: Interval, counts: &dyn Fn(&Hit) -> bool) -> bool {
        if self.tests == 1 || !steps::is_counting() {
            return self.test(ray, within, || self.geometry.any_hit(ray, within, counts));
        }
        any_part(&*self.geometry, self.shapes, &mut |part| {
            steps::count(StepKind::Test, self.shapes.tests(part));
            part.any_hit(ray, within, counts)
        })
    }
}

/// Whether this is true of any part of a mesh or of shared shapes, which are asked one after the
/// other, as in a search that a hit ends.
fn any_part(
    geometry: &dyn Geometry,
    shapes: Shapes,
    is_true: &mut dyn FnMut(&dyn Geometry) -> bool,
) -> bool {
    let kind = shapes.row(geometry).and_then(|row| row.get(geometry));
    if let Some(Content::Children {
        shapes: parts,
        transform: None,
    }) = kind.map(ShapeKind::content)
    {
        let mut parts = parts.into_iter();
        return parts.any(|part| any_part(part, shapes, is_true));
    }
    is_true(geometry)
}

impl InstrumentedGeometry {
    /// Reports a test and the steps in it.
    fn test<T>(&self, ray: &Ray, within: Interval, task: impl FnOnce() -> T) -> T {
        let step = |kind| steps::untraced(|| self.step(kind, ray, within));
        steps::inside(StepKind::Test, self.tests, step, || {
            if let Some(kind) = self.row.and_then(|row| row.get(&*self.geometry)) {
                kind.push_object_ray(ray);
            }
            task()
        })
    }

    /// The step of a test. A ray without a hit gets the `t` that the geometry gives for the whole
    /// ray, or else for the whole line.
    fn step(&self, step_kind: StepKind, ray: &Ray, within: Interval) -> Step {
        let section = self.row.map_or(ANY_SHAPE, |row| row.section);
        let line = Interval {
            min: f64::NEG_INFINITY,
            ..Interval::AHEAD
        };
        let mut step = Step::new(step_kind, &*self.name, section)
            .about(type_name(&*self.geometry))
            .numbered(self.number);
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
            .with("geometric normal", array(hit.geometric_normal))
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

/// The world with its geometries wrapped, which may be of these shapes, and its surfaces replaced
/// by this function of them.
pub fn world<S, T>(world: World<S>, shapes: Shapes, surface: impl Fn(S) -> T) -> World<T> {
    map_world(world, |number, own| geometry(number, own, shapes), surface)
}

/// The world with its geometries, counted from 1, and surfaces replaced by these functions of
/// them.
pub fn map_world<S, T>(
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
