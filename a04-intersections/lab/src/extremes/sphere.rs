//! Far, huge and tiny spheres, tangent rays, and rays from inside.

use a02_math::{Direction, Point3};
use common::{ArgumentError, Color};
use measure::Effort;
use measure::extremes::{
    Absolute, Bound, Case, Fails, Holds, Id, Nothing, Number, Outcome, Refused, Ulps, greatest,
    tried,
};

use super::{EPSILON, meeting};
use crate::experiments::sphere_distance::{Formula, at_ground, error, ours, shots};
use crate::formula::sphere::Shot;
use crate::line::{Line, line};
use crate::protocol::{self, Quadratic};
use crate::subject::SPHERE;
use crate::support::{Triple, first, vector};
use a04_intersections::{Geometry, Interval, Sphere, World};

/// A sphere, unchecked.
#[derive(Clone, Copy)]
struct Ball {
    center: Triple,
    radius: f64,
}

const fn ball(center: Triple, radius: f64) -> Ball {
    Ball { center, radius }
}

const ORIGIN: Triple = [0.0; 3];
const UNIT: Ball = ball(ORIGIN, 1.0);
const UP: Triple = [0.0, 0.0, 1.0];
const DOWN: Triple = [0.0, 0.0, -1.0];

/// The line downwards from a point over the x axis.
fn from(x: f64, z: f64) -> Line {
    line([x, 0.0, z], DOWN)
}

/// The line along the x axis, from a point of the plane z = 0.
fn along_x(x: f64, y: f64) -> Line {
    line([x, y, 0.0], [1.0, 0.0, 0.0])
}

/// The sphere whose top is the origin.
fn ground(radius: f64) -> Ball {
    ball([0.0, -radius, 0.0], radius)
}

/// Error bound of the renderer's formula: four rounding errors of the distance
/// to the centre, or of the radius if that is greater, over the cosine.
fn stable(length: f64, cosine: f64) -> Bound {
    Absolute(4.0 * EPSILON * length / cosine)
}

/// The first hit of a sphere, by our formula and by the protocol's.
fn met(ball: Ball, line: Line) -> Case {
    let [x, y, z] = ball.center;
    SPHERE.met(&[x, y, z, ball.radius], line)
}

fn unit() -> Result<Sphere, ArgumentError> {
    Sphere::new(Point3::ORIGIN, 1.0)
}

/// A line towards the unit sphere.
fn towards_unit(line: Line) -> Shot {
    Shot {
        center: UNIT.center,
        radius: UNIT.radius,
        line,
    }
}

/// The unit sphere from 3 away along a direction of another length: distances.
fn along_a_length(id: Id, length: f64) -> Case {
    let line = line([0.0, 0.0, 3.0], [0.0, 0.0, -length]);
    let theirs = protocol::sphere(&towards_unit(line)).map(|t| t * length);
    Case {
        id,
        what: format!("distance 2 along a direction of length {length:e}"),
        exact: Number(2.0),
        bound: Ulps(1.0),
        protocol: Fails,
        ..Case::of(meeting(unit(), line), theirs)
    }
}

/// A ray that no scene contains, passed directly to the unit sphere.
fn unchecked(line: Line) -> Case {
    let ours = unit().map(|sphere| first(&sphere, &line.raw_ray()));
    Case::of(ours, protocol::sphere(&towards_unit(line)))
}

/// The greatest error of `t` on a ground of this radius.
fn off_ground(radius: f64, count: usize) -> Case {
    let shots = shots::<f64>(at_ground, radius, count);
    let greatest_error = |formula: Formula<f64>| {
        let deviations = shots.iter().filter_map(|shot| error(shot, formula(shot)));
        greatest(deviations.map(|deviation| deviation.error))
    };
    Case::of(greatest_error(ours), greatest_error(protocol::sphere))
}

/// The cosine between the normal of a hit from inside the unit sphere and the ray: of the hit in a
/// world, where the normal faces the eye, and of the shape's, as in the protocol, where it points
/// outwards.
fn seen_from_inside() -> Case {
    let inside = line(ORIGIN, UP);
    let facing = tried(|| {
        let world = World::new(Color::BLACK)?.with(unit()?, ());
        let hit = world.hit(&inside.unit_ray()?, Interval::AHEAD);
        Ok(hit.map(|(hit, ())| hit.normal.dot(vector(UP))))
    });
    let outwards = tried(|| {
        let hit = unit()?.hit(&inside.raw_ray(), Interval::AHEAD);
        Ok(hit.map(|hit| hit.normal.dot(vector(UP))))
    });
    Case::of(facing, outwards)
}

/// A miss, where the protocol draws the root before it tests its sign.
fn root_of_a_miss() -> Case {
    let past = along_x(-5.0, 2.0);
    let Quadratic { a, b, discriminant } = protocol::sphere_equation(&towards_unit(past));
    let theirs: Outcome = ((-b - discriminant.sqrt()) / (2.0 * a)).into();
    Case::of(meeting(unit(), past), theirs)
}

pub fn cases(effort: Effort) -> Vec<Case> {
    [
        far(),
        grounds(effort),
        at_the_surface(),
        tangents(),
        sizes(),
        odd_rays(),
        lengths(),
    ]
    .concat()
}

/// Directions of any length, whose squares overflow or vanish.
fn lengths() -> Vec<Case> {
    vec![
        along_a_length("A23", 1e-200),
        along_a_length("A24", 1e-163),
        along_a_length("A25", 1e-160),
        along_a_length("A26", 1e-155),
        along_a_length("A27", 1e4),
        along_a_length("A28", 1e150),
        along_a_length("A29", 1e155),
        along_a_length("A30", 1e200),
    ]
}

/// Small spheres far away.
fn far() -> Vec<Case> {
    vec![
        Case {
            id: "A01",
            what: "radius 1 from 1e8 away".into(),
            exact: Number(99_999_999.0),
            bound: stable(1e8, 1.0),
            protocol: Fails,
            ..met(UNIT, from(0.0, 1e8))
        },
        Case {
            id: "A02",
            what: "radius 1 from 1e12 away".into(),
            exact: Number(999_999_999_999.0),
            bound: stable(1e12, 1.0),
            protocol: Fails,
            ..met(UNIT, from(0.0, 1e12))
        },
        Case {
            id: "A03",
            what: "two radii beside it, from 1e12 away".into(),
            exact: Nothing,
            protocol: Fails,
            ..met(UNIT, from(2.0, 1e12))
        },
        Case {
            id: "A04",
            what: "half a radius beside it, from 1e9 away".into(),
            exact: Nothing,
            protocol: Fails,
            ..met(UNIT, from(1.5, 1e9))
        },
        Case {
            id: "A05",
            what: "radius 1 from 3.7e9 away along (1, 2, 3)".into(),
            exact: Number(3_741_657_385.773_941_5),
            bound: stable(3.742e9, 1.0),
            protocol: Fails,
            ..met(UNIT, line([-1e9, -2e9, -3e9], [1.0, 2.0, 3.0]))
        },
        Case {
            id: "A06",
            what: "radius 0.7 at (0.1, 0.2, 0.3) from 1e8 away".into(),
            exact: Number(99_999_999.3),
            bound: stable(1e8, 1.0),
            protocol: Fails,
            ..met(
                ball([0.1, 0.2, 0.3], 0.7),
                line([0.1, 0.2, 1e8 + 0.3], DOWN),
            )
        },
        Case {
            id: "A07",
            what: "radius 1e-12 from 1 away".into(),
            exact: Number(0.999_999_999_999),
            bound: stable(1.0, 1.0),
            protocol: Fails,
            ..met(ball(ORIGIN, 1e-12), from(0.0, 1.0))
        },
        Case {
            id: "A08",
            what: "radius 1e-9 from 1 away, half a radius off the middle".into(),
            exact: Number(0.999_999_999_133_974_6),
            bound: stable(1.0, 0.866),
            protocol: Fails,
            ..met(ball(ORIGIN, 1e-9), from(5e-10, 1.0))
        },
    ]
}

/// Spheres so large that they serve as a ground.
fn grounds(effort: Effort) -> Vec<Case> {
    let count = effort.choose(1_000, 100_000);
    let (slanted, cosine) = (line([0.3, 1.1, 0.7], [0.1, -1.0, 0.2]), 0.976);
    vec![
        Case {
            id: "A09",
            what: "ground of radius 1e6, seen from 1.1 above".into(),
            exact: Number(1.127_165_104_032_250_6),
            bound: stable(1e6, cosine),
            protocol: Holds,
            ..met(ground(1e6), slanted)
        },
        Case {
            id: "A10",
            what: format!(
                "ground of radius 1e9, {count} rays from 1 to 2 above: greatest error of t"
            ),
            exact: Number(0.0),
            bound: stable(1e9, 0.81),
            protocol: Holds,
            ..off_ground(1e9, count)
        },
        Case {
            id: "A11",
            what: "ground of radius 1e12, seen from 1.1 above: use a plane".into(),
            exact: Number(1.127_164_584_256_075_8),
            bound: stable(1e12, cosine),
            protocol: Holds,
            ..met(ground(1e12), slanted)
        },
    ]
}

/// Rays from the sphere itself, from inside it and from just above it.
fn at_the_surface() -> Vec<Case> {
    vec![
        Case {
            id: "A12",
            what: "on the sphere, looking out".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(UNIT, line([0.0, 0.0, 1.0], UP))
        },
        Case {
            id: "A13",
            what: "on the sphere, looking in".into(),
            exact: Number(2.0),
            bound: Ulps(1.0),
            protocol: Holds,
            ..met(UNIT, from(0.0, 1.0))
        },
        Case {
            id: "A14",
            what: "the same, a scene of size 1e-4".into(),
            exact: Number(2e-4),
            bound: Ulps(2.0),
            protocol: Fails,
            ..met(ball(ORIGIN, 1e-4), from(0.0, 1e-4))
        },
        Case {
            id: "A15",
            what: "1e-12 below the surface, looking out".into(),
            exact: Number(9.999_778_782_798_785e-13),
            bound: stable(1.0, 1.0),
            protocol: Fails,
            ..met(UNIT, line([0.0, 0.0, 1.0 - 1e-12], UP))
        },
        Case {
            id: "A16",
            what: "1e-9 above the surface, looking down".into(),
            exact: Number(1.000_000_082_740_371e-9),
            bound: stable(1.0, 1.0),
            protocol: Fails,
            ..met(UNIT, from(0.0, 1.0 + 1e-9))
        },
        Case {
            id: "A17",
            what: "in the centre".into(),
            exact: Number(1.0),
            protocol: Holds,
            ..met(UNIT, line(ORIGIN, [1.0, 2.0, 2.0]))
        },
        Case {
            id: "A18",
            what: "behind the eye".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(UNIT, from(0.0, -3.0))
        },
        Case {
            id: "A40",
            what: "seen from inside: cosine between normal and direction".into(),
            exact: Number(-1.0),
            protocol: Fails,
            ..seen_from_inside()
        },
        Case {
            id: "A41",
            what: "past the sphere: the root drawn before its sign is tested".into(),
            exact: Nothing,
            protocol: Fails,
            ..root_of_a_miss()
        },
    ]
}

/// Rays that just touch the sphere, or just do not.
fn tangents() -> Vec<Case> {
    vec![
        Case {
            id: "A19",
            what: "tangent: touching is meeting".into(),
            exact: Number(5.0),
            protocol: Holds,
            ..met(UNIT, along_x(-5.0, 1.0))
        },
        Case {
            id: "A42",
            what: "tangent at its own origin, where t is 0".into(),
            exact: Nothing,
            protocol: Holds,
            ..met(UNIT, line([1.0, 0.0, 0.0], UP))
        },
        Case {
            id: "A20",
            what: "one unit in the last place beside the tangent".into(),
            exact: Nothing,
            protocol: Fails,
            ..met(UNIT, along_x(-5.0, 1.0_f64.next_up()))
        },
        Case {
            id: "A21",
            what: "half a unit in the last place below the tangent".into(),
            exact: Number(4.999_999_985_098_839),
            bound: Ulps(2.0),
            protocol: Fails,
            ..met(UNIT, along_x(-5.0, 1.0_f64.next_down()))
        },
        Case {
            id: "A22",
            what: "1e-9 beside the tangent, from 1e6 away".into(),
            exact: Nothing,
            protocol: Fails,
            ..met(UNIT, along_x(-1e6, 1.0 + 1e-9))
        },
    ]
}

/// Radii that the constructor refuses.
fn sizes() -> Vec<Case> {
    vec![
        Case {
            id: "A31",
            what: "radius 0".into(),
            exact: Refused,
            protocol: Fails,
            ..met(ball(ORIGIN, 0.0), from(0.0, 3.0))
        },
        Case {
            id: "A32",
            what: "radius -1".into(),
            exact: Refused,
            protocol: Fails,
            ..met(ball(ORIGIN, -1.0), from(0.0, 3.0))
        },
        Case {
            id: "A33",
            what: "a scene of size 1e-170, whose squares vanish".into(),
            exact: Refused,
            protocol: Fails,
            ..met(ball(ORIGIN, 1e-170), from(0.0, 3e-170))
        },
        Case {
            id: "A34",
            what: "a scene of size 1e160, whose squares are infinite".into(),
            exact: Refused,
            protocol: Fails,
            ..met(ball(ORIGIN, 1e160), from(0.0, 3e160))
        },
        Case {
            id: "A36",
            what: "infinite radius".into(),
            exact: Refused,
            protocol: Fails,
            ..met(ball(ORIGIN, f64::INFINITY), from(0.0, 3.0))
        },
    ]
}

/// Rays that no scene contains, and one with negative zeros.
fn odd_rays() -> Vec<Case> {
    vec![
        Case {
            id: "A35",
            what: "direction 0, past the constructor".into(),
            exact: Nothing,
            protocol: Fails,
            ..unchecked(line([0.0, 0.0, 3.0], ORIGIN))
        },
        Case {
            id: "A37",
            what: "an origin of NaN, past the constructor".into(),
            exact: Nothing,
            protocol: Holds,
            ..unchecked(from(f64::NAN, 3.0))
        },
        Case {
            id: "A38",
            what: "an infinite direction, past the constructor".into(),
            exact: Nothing,
            protocol: Holds,
            ..unchecked(line([0.0, 0.0, 3.0], [0.0, 0.0, f64::NEG_INFINITY]))
        },
        Case {
            id: "A39",
            what: "a direction with two negative zeros".into(),
            exact: Number(2.0),
            protocol: Holds,
            ..met(UNIT, line([0.0, 0.0, 3.0], [-0.0, -0.0, -1.0]))
        },
    ]
}
