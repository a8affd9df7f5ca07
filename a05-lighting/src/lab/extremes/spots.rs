//! Points at the edge of a cone, on its axis, and behind the light.

use std::f64::consts::PI;

use a02_math::lab::extremes::{point, vector};
use a02_math::lab::protocol::angle_by_arc_cosine;
use a02_math::{Point3, Vector3};
use a04_intersections::lab::support::Numbers;
use common::Color;
use measure::Effort;
use measure::extremes::{Case, Equal, Fails, Holds, Id, Outcome, Protocol, Refused, Ulps};

use crate::lab::protocol;
use crate::{Light, SpotLight};

/// Direction and half angle of a spot light at the origin.
type Cone = (Vector3, f64);

/// Whether a spot light shines on a point.
fn ours((direction, half_angle): Cone, point: Point3) -> Outcome {
    let light = SpotLight::new(Color::WHITE, Point3::ORIGIN, direction, half_angle);
    light.map(|light| light.illuminates(point)).into()
}

fn theirs((direction, half_angle): Cone, point: Point3) -> Outcome {
    protocol::spot_light_illuminates(Point3::ORIGIN, direction, half_angle, point).into()
}

fn spot(
    id: Id,
    what: &str,
    (direction, half_angle): ([f64; 3], f64),
    at: [f64; 3],
    exact: impl Into<Outcome>,
    says: Protocol,
) -> Case {
    let (cone, at) = ((vector(direction), half_angle), point(at));
    Case::new(
        id,
        format!("spot, {what}: lit"),
        exact,
        Equal,
        ours(cone, at),
    )
    .protocol(says, theirs(cone, at))
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    let count = effort.choose(10_000, 100_000);
    let (ones, ahead) = ([1.0; 3], [0.0, 0.0, -1.0]);
    let beside = |angle: f64| [libm::sin(angle), 0.0, -libm::cos(angle)];
    // Directions of any length below √3.
    let number = |is_counted: &dyn Fn(Vector3) -> bool| {
        let directions = (0..count).map(|i| Numbers::new(9, i).triple(-1.0, 1.0));
        directions.filter(|v| is_counted(*v)).count()
    };
    let behind = |is_lit: fn(Cone, Point3) -> Outcome|
        number(&|v| is_lit((v, 0.1), Point3::ORIGIN - v * 3.0) == true.into());
    let not_numbers = |angle: fn(Vector3, Vector3) -> f64| number(&|v| angle(v, v * 3.0).is_nan());
    let (x, diagonal) = (Vector3::new(2.0, 0.0, 0.0), Vector3::new(1.0, 1.0, 0.0));
    vec![
        spot("F06", "a point on the axis", (ones, 0.1), ones, true, Holds),
        spot("F07", "a point straight behind", (ones, 0.1), [-1.0; 3], false, Fails),
        spot("F08", "half angle 0, a point on the axis", ([1.0, 1.0, 8.0], 0.0), [1.0, 1.0, 8.0], Refused, Fails),
        spot("F09", "half angle π, a point straight behind", (ahead, PI), [0.0, 0.0, 1.0], true, Holds),
        spot("F10", "half angle 1e-9, a point at 1e-8", (ahead, 1e-9), beside(1e-8), Refused, Fails),
        spot("F11", "the position itself", (ahead, 0.1), [0.0; 3], false, Fails),
        spot("F12", "half angle NaN", (ahead, f64::NAN), ahead, Refused, Fails),
        spot("F13", "a point 1e200 away on the axis", (ahead, 0.1), [0.0, 0.0, -1e200], true, Fails),
        spot("F37", "half angle 1e-7, a point at 1.2e-7", (ahead, 1e-7), beside(1.2e-7), false, Holds),
        spot("F38", "half angle 1e-7, a point at 0.8e-7", (ahead, 1e-7), beside(0.8e-7), true, Holds),
        Case::new("I09", format!("spot, {count} points straight behind: lit"), 0.0, Equal, behind(ours))
            .protocol(Fails, behind(theirs)),
        Case::new("S15", format!("{count} angles between parallel vectors: NaN"),
            0.0, Equal, not_numbers(Vector3::angle)).protocol(Fails, not_numbers(angle_by_arc_cosine)),
        Case::new("F39", "angle between (2, 0, 0) and (1, 1, 0)", PI / 4.0, Ulps(1.0), x.angle(diagonal))
            .protocol(Fails, protocol::angle(x, diagonal)),
    ]
}
