//! Points at the edge of a cone, on its axis, and behind the light.

use std::f64::consts::PI;

use a02_math::{Point3, Vector3};
use a03_rays_cameras::PixelRandom;
use common::Color;
use measure::Effort;
use measure::extremes::Protocol::{Fails, Holds};
use measure::extremes::{Bound, Case, Outcome, Protocol};

use crate::{Light, SpotLight, protocol};

pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(10_000, 100_000);
    let diagonal = [1.0, 1.0, 1.0];
    let ahead = [0.0, 0.0, -1.0];
    let beside = |angle: f64| [libm::sin(angle), 0.0, -libm::cos(angle)];
    let refused = Outcome::Refused;
    vec![
        spot(
            "F06",
            "a point on the axis",
            diagonal,
            0.1,
            diagonal,
            true,
            Holds,
        ),
        spot(
            "F07",
            "a point straight behind",
            diagonal,
            0.1,
            [-1.0, -1.0, -1.0],
            false,
            Fails,
        ),
        spot(
            "F08",
            "half angle 0, a point on the axis",
            [1.0, 1.0, 8.0],
            0.0,
            [1.0, 1.0, 8.0],
            refused,
            Fails,
        ),
        spot(
            "F09",
            "half angle π, a point straight behind",
            ahead,
            PI,
            [0.0, 0.0, 1.0],
            true,
            Holds,
        ),
        spot(
            "F10",
            "half angle 1e-9, a point at 1e-8",
            ahead,
            1e-9,
            beside(1e-8),
            refused,
            Fails,
        ),
        spot(
            "F11",
            "the position itself",
            ahead,
            0.1,
            [0.0; 3],
            false,
            Fails,
        ),
        spot(
            "F12",
            "half angle NaN",
            ahead,
            f64::NAN,
            ahead,
            refused,
            Fails,
        ),
        spot(
            "F13",
            "a point 1e200 away on the axis",
            ahead,
            0.1,
            [0.0, 0.0, -1e200],
            true,
            Fails,
        ),
        spot(
            "F37",
            "half angle 1e-7, a point at 1.2e-7",
            ahead,
            1e-7,
            beside(1.2e-7),
            false,
            Holds,
        ),
        spot(
            "F38",
            "half angle 1e-7, a point at 0.8e-7",
            ahead,
            1e-7,
            beside(0.8e-7),
            true,
            Holds,
        ),
        behind("I09", count),
        angles("S15", count),
        formula("F39"),
    ]
}

fn vector(v: [f64; 3]) -> Vector3 {
    Vector3::from_glam(v.into())
}

/// Whether a spot light at the origin shines on a point.
fn spot(
    id: &'static str,
    what: &str,
    direction: [f64; 3],
    half_angle: f64,
    point: [f64; 3],
    exact: impl Into<Outcome>,
    says: Protocol,
) -> Case {
    let (direction, point) = (vector(direction), Point3::from_glam(point.into()));
    let light = SpotLight::new(Color::WHITE, Point3::ORIGIN, direction, half_angle);
    let ours = light.map(|light| light.illuminates(point));
    let theirs = protocol::spot_light_illuminates(Point3::ORIGIN, direction, half_angle, point);
    Case::new(id, format!("spot, {what}: lit"), exact, Bound::Equal, ours).protocol(says, theirs)
}

/// A direction of any length below √3.
fn random_direction(i: usize) -> Vector3 {
    let random = PixelRandom::new(9, i as u32, 0);
    let number = |n| 2.0 * random.uniform(n) - 1.0;
    Vector3::new(number(0), number(1), number(2))
}

/// Points straight behind lights of random directions.
fn behind(id: &'static str, count: usize) -> Case {
    let lit = |illuminates: fn(Vector3, Point3) -> bool| {
        let is_lit = |i: &usize| {
            let direction = random_direction(*i);
            illuminates(direction, Point3::ORIGIN - direction * 3.0)
        };
        (0..count).filter(is_lit).count()
    };
    let ours = |direction, point| {
        let light = SpotLight::new(Color::WHITE, Point3::ORIGIN, direction, 0.1);
        light.is_ok_and(|light| light.illuminates(point))
    };
    let theirs =
        |direction, point| protocol::spot_light_illuminates(Point3::ORIGIN, direction, 0.1, point);
    let what = format!("spot, {count} points straight behind: lit");
    Case::new(id, what, 0.0, Bound::Equal, lit(ours)).protocol(Fails, lit(theirs))
}

/// Angles between parallel vectors.
fn angles(id: &'static str, count: usize) -> Case {
    let not_numbers = |angle: fn(Vector3, Vector3) -> f64| {
        let is_none = |i: &usize| {
            let a = random_direction(*i);
            angle(a, a * 3.0).is_nan()
        };
        (0..count).filter(is_none).count()
    };
    let arc = |a: Vector3, b: Vector3| {
        use a02_math::Direction;
        libm::acos(a.dot(b) / (a.magnitude() * b.magnitude()))
    };
    let what = format!("{count} angles between parallel vectors: NaN");
    Case::new(id, what, 0.0, Bound::Equal, not_numbers(Vector3::angle))
        .protocol(Fails, not_numbers(arc))
}

/// The angle between the x axis and the diagonal of x and y.
fn formula(id: &'static str) -> Case {
    let (a, b) = (Vector3::new(2.0, 0.0, 0.0), Vector3::new(1.0, 1.0, 0.0));
    Case::new(
        id,
        "angle between (2, 0, 0) and (1, 1, 0)",
        PI / 4.0,
        Bound::Ulps(1.0),
        a.angle(b),
    )
    .protocol(Fails, protocol::angle(a, b))
}
