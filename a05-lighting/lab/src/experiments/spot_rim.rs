//! Points at the rim of a spot light's cone.

use std::rc::Rc;

use a02_math::{Direction, Point3, Vector3};
use a03_rays_cameras::PixelRandom;
use common::{ArgumentError, Color};
use measure::Effort;
use measure::experiment::{Axis, Curve, ErrorBound, Experiment, TaskSet, Unit};

use crate::protocol;
use a05_lighting::{Light, SpotLight};

const HALF_ANGLE: f64 = 1e-3;
const COS_HALF_ANGLE: f64 = 0.999_999_500_000_041_7;
const DIRECTION: Vector3 = Vector3::new(1.0, 2.0, 3.0);
const SEED: u64 = 12;

/// One half of the points lies inside and one outside, all at the same distance from the rim;
/// every eighth lies straight behind.
pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "How near to the rim of a spot light is inside told from outside?",
        parameter: "from rim (half angles)",
        work: "points",
        against: Axis::Parameter,
        error: "fraction of points judged wrongly",
        unit: Unit::Fraction,
        exact: "against the side on which a point was put; one in eight lies behind",
        seeds: &[SEED],
        curves: Box::new(curves),
        ..Experiment::new("spot-rim")
    }
}

/// Whether a light at the origin shines on a point.
type Illuminates = fn(&SpotLight, Point3) -> bool;

fn arc_cosine(_: &SpotLight, point: Point3) -> bool {
    protocol::spot_light_illuminates(Point3::ORIGIN, DIRECTION, HALF_ANGLE, point)
}

/// As the renderer's light decides, but without a normalised direction.
fn cosines(_: &SpotLight, point: Point3) -> bool {
    let v = point - Point3::ORIGIN;
    let lengths = (v.dot(v) * DIRECTION.dot(DIRECTION)).sqrt();
    v.dot(DIRECTION) >= COS_HALF_ANGLE * lengths
}

fn arc_tangent(_: &SpotLight, point: Point3) -> bool {
    DIRECTION.angle(point - Point3::ORIGIN) <= HALF_ANGLE
}

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let count = effort.choose(4_096, 65_536) as u32;
    let mut sets = Vec::new();
    for parameter in [1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10, 1e-11] {
        let tasks = tasks(parameter, count).unwrap_or_default();
        sets.push(TaskSet { parameter, tasks });
    }
    let curve = |method, illuminates: Illuminates| {
        let is_lit = move |task: &Task| illuminates(&task.light, task.point);
        let is_wrong = |task: &Task, is_lit| is_lit != task.is_lit;
        Curve::of_decisions(method, &sets, is_lit, is_wrong)
    };
    // Rounding is far below a billionth of the half angle.
    let exact_from_afar = Some(ErrorBound {
        error: 0.0,
        between: 1e-9..=1.0,
    });
    vec![
        curve("arc cosine (protocol)", arc_cosine),
        Curve {
            bound: exact_from_afar.clone(),
            ..curve("cosines", cosines)
        },
        Curve {
            bound: exact_from_afar,
            ..curve("cosines, as rendered", Light::illuminates)
        },
        curve("arc tangent", arc_tangent),
    ]
}

/// A light at the origin, and a point on which it shines or not.
struct Task {
    light: SpotLight,
    point: Point3,
    is_lit: bool,
}

/// Points near the rim of the light's cone.
fn tasks(parameter: f64, count: u32) -> Result<Rc<[Task]>, ArgumentError> {
    let light = SpotLight::new(Color::WHITE, Point3::ORIGIN, DIRECTION, HALF_ANGLE)?;
    let w = DIRECTION.unit("direction")?;
    let u = w.cross(Vector3::new(0.0, 1.0, 0.0)).unit("u")?;
    let v = w.cross(u);
    let mut tasks = Vec::new();
    for i in 0..count {
        let random = PixelRandom::new(SEED, i, 0);
        let distance = 1.0 + 9.0 * random.uniform(0);
        if i % 8 == 0 {
            tasks.push(Task {
                light,
                point: Point3::ORIGIN - DIRECTION * distance,
                is_lit: false,
            });
            continue;
        }
        let is_inside = random.uniform(1) < 0.5;
        let angle = if is_inside {
            HALF_ANGLE * (1.0 - parameter)
        } else {
            HALF_ANGLE * (1.0 + parameter)
        };
        let around = 6.3 * random.uniform(2);
        let aside = u * libm::cos(around) + v * libm::sin(around);
        let direction = w * libm::cos(angle) + aside * libm::sin(angle);
        tasks.push(Task {
            light,
            point: Point3::ORIGIN + direction * distance,
            is_lit: is_inside,
        });
    }
    Ok(tasks.into())
}
