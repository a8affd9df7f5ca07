//! The shadow terminator of a coarse ball: light that its triangles take from each other.

use std::rc::Rc;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval};
use a04_lab::support::Numbers;
use common::{Color, Error};
use measure::experiment::{Axis, Curve, ErrorBound, Experiment, Slope, TaskSet};

use crate::coarse_ball::{CoarseBall, ON_THE_CURVED_SURFACE, ON_THE_TRIANGLE, Start, coarse_ball};

/// The light that a point of a ball should get and does not, against the number N of triangles.
///
/// The normal of a triangle differs from the ball's normal n at one of its points by a vector δ
/// along the surface, as long as the triangles are wide: `|δ| ~ N^(-1/2)`. The body is convex, so a
/// point with `n · l > 0` is dark just where its triangle faces away, where `n · l < δ · l`. As
/// `n · l` is equally often each number from 0 to 1, and the lost light is `n · l` itself, the mean
/// of its square is that of `(δ · l)³ / 3`. Its root falls as `N^(-3/4)`.
///
/// From Hanika's start no light is lost at all. By the weights w of the corners c, a point p of the
/// ball's normal n has `p · n = μ`, the mean of `c · n`, whose variance is σ². Its start s has
/// `s · n = μ (2 - μ² - σ²)`. From 20 triangles on this is at least 1, so that the whole body
/// lies below the plane through s with the normal n, and the ray above it.
pub fn experiment() -> Experiment<'static> {
    Experiment {
        question: "How much light does a coarse ball take from itself?",
        parameter: "triangles",
        work: "shadow rays",
        against: Axis::Parameter,
        error: "rms error of the brightness",
        exact: "against the cosine n · l of the ball",
        seeds: &[SEED],
        curves: Box::new(curves),
        ..Experiment::new("shadow-terminator")
    }
}

fn curves() -> Vec<Curve<'static>> {
    // Each ray is tested against each triangle.
    let mut sets = Vec::new();
    for divisions in 0..=3 {
        sets.push(TaskSet {
            parameter: f64::from(20 * 4_u32.pow(divisions)),
            tasks: lit_points(divisions).unwrap_or_default(),
        });
    }
    let curve = |method, start: Start| {
        let is_shadowed = move |point: &LitPoint| point.is_shadowed(start);
        Curve::of_tasks(method, &sets, is_shadowed, LitPoint::lost_light)
    };
    vec![
        Curve {
            slope: Some(Slope {
                value: -0.75,
                between: 80.0..=f64::INFINITY,
            }),
            ..curve("from the triangle (ours)", ON_THE_TRIANGLE)
        },
        Curve {
            bound: Some(ErrorBound {
                error: 0.0,
                between: 0.0..=f64::INFINITY,
            }),
            ..curve("above it (Hanika)", ON_THE_CURVED_SURFACE)
        },
    ]
}

const SEED: u64 = 17;

/// A point of a coarse ball that the light shines on: the ball's normal there is at less than a
/// right angle to the light.
struct LitPoint {
    ball: Rc<CoarseBall>,
    /// The ray that sees the point.
    ray: Ray,
    hit: Hit,
    corners: [Point3; 3],
    /// Of length 1.
    to_light: Vector3,
    /// Of the angle between the ball's normal and the light.
    cosine: f64,
}

impl LitPoint {
    /// Whether a triangle blocks the light.
    fn is_shadowed(&self, start: Start) -> bool {
        let to_light = start(&self.ray, &self.hit, &self.corners, self.to_light);
        self.ball.is_hit(&to_light, Interval::AHEAD)
    }

    /// The light that should arrive, if a triangle blocks it.
    fn lost_light(&self, is_shadowed: bool) -> [f64; 1] {
        [if is_shadowed { self.cosine } else { 0.0 }]
    }
}

/// Points all over a ball, seen from straight above them, in lights at all angles.
fn lit_points(divisions: u32) -> Result<Rc<[LitPoint]>, Error> {
    let ball = Rc::new(coarse_ball(divisions, Color::BLACK)?);
    let count = 4_096;
    let mut points = Vec::new();
    for n in 0..count {
        let mut numbers = Numbers::new(SEED, n);
        let [outwards, aside] = numbers.perpendicular();
        let ray = Ray::new(Point3::ORIGIN + outwards * 3.0, -outwards)?;
        let Some((hit, corners)) = ball.hit(&ray, Interval::AHEAD) else {
            continue;
        };
        // Evenly spread cosines, one in each of as many parts as there are points.
        let cosine = (n as f64 + numbers.between(0.0, 1.0)) / count as f64;
        let to_light = outwards * cosine + aside * (1.0 - cosine * cosine).sqrt();
        points.push(LitPoint {
            ball: Rc::clone(&ball),
            ray,
            hit,
            corners: *corners,
            to_light,
            cosine,
        });
    }
    Ok(points.into())
}
