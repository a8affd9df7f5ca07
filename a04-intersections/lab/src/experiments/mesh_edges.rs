//! Triangle tests at the edges of a closed mesh: a ray that no triangle stops is a leak.

use std::rc::Rc;

use a02_math::Point3;
use a02_math::arrays::array;
use a03_rays_cameras::Ray;
use common::Error;
use measure::Effort;
use measure::experiment::{Axis, Curve, ErrorBound, Experiment, TaskSet, Unit};

use crate::closed_mesh::{Aim, ClosedMesh};
use crate::formula::triangle::{self, watertight};
use crate::line::Line;
use crate::number::{Real, Triple};
use crate::protocol;
use crate::support::{corners, first};
use a04_intersections::Triangle;

/// The longer the mesh, the thinner are its triangles, and the coarser the weights of a hit. Its
/// triangles share their corners, so that it is closed however the corners are rounded.
pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "Which triangle test lets rays out of a closed mesh?",
        parameter: "length / width of the mesh",
        work: "rays",
        against: Axis::Parameter,
        error: "fraction of rays that get out",
        unit: Unit::Fraction,
        exact: "none gets out; rays aim at corners, edges and their middles",
        seeds: &[51, 52],
        curves: Box::new(curves),
        ..Experiment::new("mesh-edges")
    }
}

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let (mut lessons, mut protocols) = (Vec::new(), Vec::new());
    let (mut doubles, mut singles) = (Vec::new(), Vec::new());
    for parameter in [1.0, 1e2, 1e4, 1e6, 1e8] {
        let lesson = tasks(parameter, effort).unwrap_or_default();
        protocols.push(TaskSet {
            parameter,
            tasks: converted(&lesson, corners, |ray| *ray),
        });
        doubles.push(TaskSet {
            parameter,
            tasks: converted(&lesson, numbers::<f64>, Line::of),
        });
        // In single precision a longer mesh has no width.
        if parameter <= 1e4 {
            singles.push(TaskSet {
                parameter,
                tasks: converted(&lesson, numbers::<f32>, |ray| Line::of(ray).to()),
            });
        }
        lessons.push(TaskSet {
            parameter,
            tasks: lesson.into(),
        });
    }
    let never = ErrorBound {
        error: 0.0,
        between: 0.0..=f64::INFINITY,
    };
    vec![
        curve("Cramer (protocol)", &protocols, |corners, ray| {
            protocol::triangle(corners, ray).is_some()
        }),
        curve("Möller-Trumbore", &doubles, moeller_trumbore),
        curve("Möller-Trumbore, tolerance 1e-9", &doubles, wider),
        Curve {
            bound: Some(never.clone()),
            ..curve("Woop (split)", &doubles, |corners, line| {
                woop(corners, line, triangle::split)
            })
        },
        curve("Möller-Trumbore (single)", &singles, moeller_trumbore),
        Curve {
            bound: Some(never.clone()),
            ..curve("Woop (single)", &singles, |corners, line| {
                woop(corners, line, triangle::rounded)
            })
        },
        Curve {
            bound: Some(never),
            ..curve("Woop (ours)", &lessons, |triangle, ray| {
                first(triangle, ray).is_some()
            })
        },
    ]
}

/// The leaks of a test.
fn curve<T: 'static, R: 'static>(
    method: &'static str,
    sets: &[TaskSet<Task<T, R>>],
    is_hit: fn(&T, &R) -> bool,
) -> Curve<'static> {
    let is_held = move |task: &Task<T, R>| task.is_held(is_hit);
    Curve::of_decisions(method, sets, is_held, |_, is_held| !is_held)
}

/// The corners of a triangle.
type Corners<F> = [Triple<F>; 3];

/// A closed mesh of triangles, and a ray from inside.
struct Task<T, R> {
    triangles: Rc<[T]>,
    ray: R,
}

impl<T, R> Task<T, R> {
    /// Whether a triangle stops the ray.
    fn is_held(&self, is_hit: fn(&T, &R) -> bool) -> bool {
        let mut triangles = self.triangles.iter();
        triangles.any(|triangle| is_hit(triangle, &self.ray))
    }
}

/// Rays in a mesh that is so many times as long as wide.
fn tasks(stretch: f64, effort: Effort) -> Result<Vec<Task<Triangle, Ray>>, Error> {
    let count = effort.choose(256, 4_096);
    let mesh = ClosedMesh::stretched(Point3::new(0.1, 0.2, 0.3), stretch)?;
    let triangles: Rc<[Triangle]> = mesh.triangles.as_slice().into();
    let mut tasks = Vec::new();
    for aim in [Aim::Corners, Aim::Edges, Aim::MiddlesOfEdges] {
        for n in 0..count {
            tasks.push(Task {
                triangles: Rc::clone(&triangles),
                ray: mesh.ray(aim, n)?,
            });
        }
    }
    Ok(tasks)
}

/// The tasks in other types.
fn converted<T, R>(
    tasks: &[Task<Triangle, Ray>],
    triangle: impl Fn(&Triangle) -> T,
    ray: impl Fn(&Ray) -> R,
) -> Rc<[Task<T, R>]> {
    let Some(first) = tasks.first() else {
        return Rc::new([]);
    };
    let triangles: Rc<[T]> = first.triangles.iter().map(triangle).collect();
    let mut all = Vec::new();
    for task in tasks {
        all.push(Task {
            triangles: Rc::clone(&triangles),
            ray: ray(&task.ray),
        });
    }
    all.into()
}

/// The corners in numbers of a type. Neighbours still share them, because equal numbers are
/// rounded to equal ones.
fn numbers<F: Real>(triangle: &Triangle) -> Corners<F> {
    corners(triangle).map(|corner| array(corner).map(F::of))
}

fn moeller_trumbore<F: Real>(corners: &Corners<F>, line: &Line<F>) -> bool {
    triangle::moeller_trumbore(corners, line).hit().is_some()
}

/// A usual cure: the triangle is larger by a billionth, also at the outline of an open mesh.
fn wider(corners: &Corners<f64>, line: &Line) -> bool {
    const MARGIN: f64 = 1e-9;
    let meeting = triangle::moeller_trumbore(corners, line);
    let alpha = 1.0 - meeting.beta - meeting.gamma;
    let is_inside = alpha >= -MARGIN && meeting.beta >= -MARGIN && meeting.gamma >= -MARGIN;
    is_inside && meeting.t > 0.0
}

fn woop<F: Real>(
    corners: &Corners<F>,
    line: &Line<F>,
    difference_of_products: impl Fn(F, F, F, F) -> F,
) -> bool {
    watertight(corners, line, difference_of_products).is_some()
}
