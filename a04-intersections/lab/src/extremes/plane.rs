//! Planes at grazing angles, far planes, and rays that leave a plane.

use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;
use common::ArgumentError;
use measure::Effort;
use measure::extremes::{
    Absolute, Both, Case, Fails, Holds, Nothing, Number, Refused, Ulps, count_wrong,
};

use super::{EPSILON, meeting};
use crate::line::{Line, line};
use crate::protocol;
use crate::subject::PLANE;
use crate::support::{Numbers, Triple, first, vector};
use a04_intersections::{Geometry, Interval, Plane};

const UP: Triple = [0.0, 1.0, 0.0];
const DOWN: Triple = [0.0, -1.0, 0.0];

/// A plane, unchecked.
#[derive(Clone, Copy)]
struct Ground {
    point: Triple,
    normal: Triple,
}

/// The level plane at a height.
const fn level(height: f64) -> Ground {
    Ground {
        point: [0.0, height, 0.0],
        normal: UP,
    }
}

/// The plane through the origin across a vector.
const fn across(normal: Triple) -> Ground {
    Ground {
        point: [0.0; 3],
        normal,
    }
}

/// The line from a height above the origin.
fn eye(height: f64, direction: Triple) -> Line {
    line([0.0, height, 0.0], direction)
}

/// The first hit of a plane, by our formula and by the protocol's.
fn met(plane: Ground, line: Line) -> Case {
    PLANE.met(&[plane.point, plane.normal].concat(), line)
}

/// The plane y = 0 and a ray, both of lengths of 1e-200, whose product is 0, so that the protocol
/// finds no plane.
fn of_tiny_lengths() -> Case {
    let normal = vector([0.0, 1e-200, 0.0]).as_normal();
    let short = eye(1.0, [0.0, -1e-200, 0.0]);
    let theirs = protocol::plane(Point3::ORIGIN, normal, &short.raw_ray());
    let ours = meeting(Plane::new(Point3::ORIGIN, normal), short);
    Case::of(ours, theirs.map(|t| t * 1e-200))
}

fn from_infinity() -> Case {
    let (ray, up) = (eye(f64::INFINITY, DOWN).raw_ray(), vector(UP).as_normal());
    let ours = Plane::new(Point3::ORIGIN, up).map(|plane| first(&plane, &ray));
    Case::of(ours, protocol::plane(Point3::ORIGIN, up, &ray))
}

/// A plane whose point is far away within it, straight ahead of a ray.
fn of_a_far_point() -> Case {
    let n = [1.0, 2.0, 3.0].map(|x: f64| x / 14.0_f64.sqrt());
    let away = Ground {
        point: [3e6, 0.0, -1e6],
        normal: [1.0, 2.0, 3.0],
    };
    met(away, line(n.map(|x| 5.0 * x), n.map(|x| -x)))
}

pub fn cases(effort: Effort) -> Vec<Case> {
    let mut cases = [grazing(), distances()].concat();
    cases.push(Case::of_wrong(
        "B19",
        "reflected rays that meet the plane that they leave once more",
        leaving(effort),
    ));
    cases
}

/// Rays along the plane, or almost.
fn grazing() -> Vec<Case> {
    vec![
        Case {
            id: "B01",
            what: "grazing, slope 1e-15".into(),
            exact: Number(999_999_999_999_999.9),
            bound: Ulps(1.0),
            protocol: Holds,
            ..met(level(0.0), eye(1.0, [1.0, -1e-15, 0.0]))
        },
        Case {
            id: "B02",
            what: "grazing, with the least slope there is: t would be infinite".into(),
            exact: Nothing,
            protocol: Fails,
            ..met(level(0.0), eye(1.0, [1.0, -5e-324, 0.0]))
        },
        Case {
            id: "B03",
            what: "parallel, with terms that cancel".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(across([0.3, 0.5, 0.7]), eye(1.0, [0.5, -0.3, 0.0]))
        },
        Case {
            id: "B05",
            what: "from a point of the plane".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(level(0.0), line([3.0, 0.0, 4.0], DOWN))
        },
        Case {
            id: "B20",
            what: "within the plane: 0 divided by 0".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(level(0.0), line([3.0, 0.0, 4.0], [1.0, 0.0, 0.0]))
        },
        Case {
            id: "B06",
            what: "parallel, with a cosine of negative 0".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(level(0.0), eye(1.0, [1.0, -0.0, 0.0]))
        },
    ]
}

/// Far planes, and numbers at the ends of their range.
fn distances() -> Vec<Case> {
    vec![
        Case {
            id: "B04",
            what: "the plane's point is 3e6 away within it".into(),
            exact: Number(5.0),
            bound: Absolute(4.0 * EPSILON * 3.17e6),
            protocol: Holds,
            ..of_a_far_point()
        },
        Case {
            id: "B07",
            what: "normal and direction of length 1e-200: the distance".into(),
            exact: Number(1.0),
            protocol: Fails,
            ..of_tiny_lengths()
        },
        Case {
            id: "B08",
            what: "1 above the plane at 1e15".into(),
            exact: Number(1.0),
            protocol: Holds,
            ..met(level(1e15), eye(1e15 + 1.0, DOWN))
        },
        Case {
            id: "B09",
            what: "1 above the plane at 1e16, where doubles are 2 apart: on it".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(level(1e16), eye(1e16 + 1.0, DOWN))
        },
        Case {
            id: "B10",
            what: "a normal of NaN".into(),
            exact: Refused,
            protocol: Fails,
            ..met(across([f64::NAN, 1.0, 0.0]), eye(1.0, DOWN))
        },
        Case {
            id: "B11",
            what: "an infinite origin, past the constructor".into(),
            exact: Nothing,
            protocol: Fails,
            ..from_infinity()
        },
    ]
}

/// Rays that start at hits of a slanted plane. Rounding moves the point to one of
/// its sides. With `t > 0` some rays hit the same plane again; with an interval
/// that begins after a few rounding errors of the lengths, no ray does.
fn leaving(effort: Effort) -> Result<Both<usize>, ArgumentError> {
    count_wrong(0..effort.choose(1000, 20_000), |n| {
        let mut numbers = Numbers::new(31, n);
        let normal = numbers.perpendicular()[0].as_normal();
        let plane = Plane::new(Point3::ORIGIN, normal)?;
        let eye = Point3::ORIGIN + numbers.triple(-5.0, 5.0);
        let ray = Ray::new(eye, numbers.direction())?;
        let Some(hit) = plane.hit(&ray, Interval::AHEAD) else {
            return Ok(Both::default());
        };
        let away = Ray::new(ray.at(hit.t), (-ray.direction()).reflected_on(normal))?;
        // A slanted ray hits the plane at a distance of the error over the cosine.
        let rounding = 64.0 * EPSILON * eye.largest_coordinate().max(hit.t);
        let within = Interval {
            min: rounding / away.direction().dot(normal).abs(),
            ..Interval::AHEAD
        };
        Ok(Both {
            ours: plane.hit(&away, within).is_some(),
            theirs: protocol::plane(Point3::ORIGIN, normal, &away).is_some(),
        })
    })
}
