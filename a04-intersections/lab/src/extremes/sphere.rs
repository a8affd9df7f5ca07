//! Far, huge and tiny spheres, tangent rays, and rays from inside.

use a02_math::{Direction, Normal3, Point3};
use common::{ArgumentError, Color};
use measure::Effort;
use measure::extremes::{Absolute, Both, Bound, Case, Equal, Fails, Holds, Id, Outcome, Ulps};
use measure::extremes::{case, greatest, tried};

use super::{EPSILON, MISS, REFUSED, meeting};
use crate::experiments::sphere_distance::{AT_GROUND, OURS, error, shots};
use crate::protocol;
use crate::subject::SPHERE;
use crate::support::{Line, Triple, first, raw_ray, unit_ray, vector};
use a04_intersections::{Geometry, Interval, Sphere, World};

/// Centre and radius.
type Ball = (Triple, f64);

const UNIT: Ball = ([0.0; 3], 1.0);
const DOWN: Triple = [0.0, 0.0, -1.0];

/// Error bound of the renderer's formula: four rounding errors of the distance
/// to the centre, or of the radius if that is greater, over the cosine.
fn stable(length: f64, cos: f64) -> Bound {
    Absolute(4.0 * EPSILON * length / cos)
}

/// The first hit of a sphere, by our formula and by the protocol's.
fn met(([x, y, z], r): Ball, line: Line) -> Both {
    SPHERE.met(&[x, y, z, r], line)
}

/// The unit sphere from 3 away along a direction of another length: distances.
fn long_or_short((id, length): (Id, f64)) -> Case {
    let line @ (o, d) = ([0.0, 0.0, 3.0], [0.0, 0.0, -length]);
    let what = format!("distance 2 along a direction of length {length:e}");
    let theirs = protocol::sphere(&UNIT.0, UNIT.1, &o, &d).map(|t| t * length);
    Case::new(id, what, 2.0, Ulps(1.0), meeting(unit(), line)).protocol(Fails, theirs)
}

/// A ray that no scene contains, passed directly to the unit sphere.
fn unchecked(line @ (o, d): Line) -> [Outcome; 2] {
    let ours = unit().map(|sphere| first(&sphere, &raw_ray(line)));
    let theirs = protocol::sphere(&UNIT.0, UNIT.1, &o, &d);
    [ours.into(), theirs.into()]
}

fn unit() -> Result<Sphere, ArgumentError> {
    Sphere::new(Point3::ORIGIN, 1.0)
}

/// The greatest error of `t` on a ground of this radius, by our formula and the protocol's.
fn off_ground(radius: f64, count: usize) -> [Outcome; 2] {
    let shots = shots(AT_GROUND, radius, count);
    [OURS, protocol::sphere].map(|formula| {
        let off = |shot @ (c, r, o, d): &_| error(shot, formula(c, *r, o, d));
        greatest(shots.iter().filter_map(off).map(|off| off.error)).into()
    })
}

#[rustfmt::skip]
pub fn cases(effort: Effort) -> Vec<Case> {
    const ORIGIN: Triple = [0.0; 3];
    let count = effort.choose(1_000, 100_000);
    let from = |x: f64, z: f64| ([x, 0.0, z], DOWN);
    let ground = |r: f64| ([0.0, -r, 0.0], r);
    let (line, cos) = (([0.3, 1.1, 0.7], [0.1, -1.0, 0.2]), 0.976);
    let up = [0.0, 0.0, 1.0];
    let along_x = |x: f64, y: f64| ([x, y, 0.0], [1.0, 0.0, 0.0]);
    let past = along_x(-5.0, 2.0);
    // The protocol's normal points outwards, also for an eye inside.
    let from_inside = (ORIGIN, up);
    let cosine = |normal: Normal3| normal.dot(vector(up));
    let facing = tried(|| {
        let world = World::new(Color::BLACK)?.with(unit()?, ());
        let hit = world.hit(&unit_ray(from_inside)?, Interval::AHEAD);
        Ok(hit.map(|(hit, ())| cosine(hit.normal)))
    });
    let outwards = unit().map(|sphere| {
        sphere.hit(&raw_ray(from_inside), Interval::AHEAD).map(|hit| cosine(hit.normal))
    });
    let [a, b, discriminant] = protocol::sphere_terms(&ORIGIN, 1.0, &past.0, &past.1);
    let lengths = [("A23", 1e-200), ("A24", 1e-163), ("A25", 1e-160), ("A26", 1e-155),
        ("A27", 1e4), ("A28", 1e150), ("A29", 1e155), ("A30", 1e200)];
    let mut cases = vec![
        case("A01", "radius 1 from 1e8 away", met(UNIT, from(0.0, 1e8)), 99_999_999.0, stable(1e8, 1.0), Fails),
        case("A02", "radius 1 from 1e12 away",
            met(UNIT, from(0.0, 1e12)), 999_999_999_999.0, stable(1e12, 1.0), Fails),
        case("A03", "two radii beside it, from 1e12 away", met(UNIT, from(2.0, 1e12)), MISS, Equal, Fails),
        case("A04", "half a radius beside it, from 1e9 away", met(UNIT, from(1.5, 1e9)), MISS, Equal, Fails),
        case("A05", "radius 1 from 3.7e9 away along (1, 2, 3)",
            met(UNIT, ([-1e9, -2e9, -3e9], [1.0, 2.0, 3.0])), 3_741_657_385.773_941_5, stable(3.742e9, 1.0), Fails),
        case("A06", "radius 0.7 at (0.1, 0.2, 0.3) from 1e8 away", met(([0.1, 0.2, 0.3], 0.7),
            ([0.1, 0.2, 1e8 + 0.3], DOWN)), 99_999_999.3, stable(1e8, 1.0), Fails),
        case("A07", "radius 1e-12 from 1 away",
            met((ORIGIN, 1e-12), from(0.0, 1.0)), 0.999_999_999_999, stable(1.0, 1.0), Fails),
        case("A08", "radius 1e-9 from 1 away, half a radius off the middle",
            met((ORIGIN, 1e-9), from(5e-10, 1.0)), 0.999_999_999_133_974_6, stable(1.0, 0.866), Fails),
        case("A09", "ground of radius 1e6, seen from 1.1 above",
            met(ground(1e6), line), 1.127_165_104_032_250_6, stable(1e6, cos), Holds),
        case("A10", format!("ground of radius 1e9, {count} rays from 1 to 2 above: greatest error of t"),
            off_ground(1e9, count), 0.0, stable(1e9, 0.81), Holds),
        case("A11", "ground of radius 1e12, seen from 1.1 above: use a plane",
            met(ground(1e12), line), 1.127_164_584_256_075_8, stable(1e12, cos), Holds),
        case("A12", "on the sphere, looking out", met(UNIT, ([0.0, 0.0, 1.0], up)), MISS, Equal, Holds),
        case("A13", "on the sphere, looking in", met(UNIT, from(0.0, 1.0)), 2.0, Ulps(1.0), Holds),
        case("A14", "the same, a scene of size 1e-4", met((ORIGIN, 1e-4), from(0.0, 1e-4)), 2e-4, Ulps(2.0), Fails),
        case("A15", "1e-12 below the surface, looking out",
            met(UNIT, ([0.0, 0.0, 1.0 - 1e-12], up)), 9.999_778_782_798_785e-13, stable(1.0, 1.0), Fails),
        case("A16", "1e-9 above the surface, looking down",
            met(UNIT, from(0.0, 1.0 + 1e-9)), 1.000_000_082_740_371e-9, stable(1.0, 1.0), Fails),
        case("A17", "in the centre", met(UNIT, (ORIGIN, [1.0, 2.0, 2.0])), 1.0, Equal, Holds),
        case("A18", "behind the eye", met(UNIT, from(0.0, -3.0)), MISS, Equal, Holds),
        case("A19", "tangent: touching is meeting", met(UNIT, along_x(-5.0, 1.0)), 5.0, Equal, Holds),
        case("A42", "tangent at its own origin, where t is 0",
            met(UNIT, ([1.0, 0.0, 0.0], up)), MISS, Equal, Holds),
        case("A20", "one unit in the last place beside the tangent",
            met(UNIT, along_x(-5.0, 1.0_f64.next_up())), MISS, Equal, Fails),
        case("A21", "half a unit in the last place below the tangent",
            met(UNIT, along_x(-5.0, 1.0_f64.next_down())), 4.999_999_985_098_839, Ulps(2.0), Fails),
        case("A22", "1e-9 beside the tangent, from 1e6 away", met(UNIT, along_x(-1e6, 1.0 + 1e-9)), MISS, Equal, Fails),
        case("A31", "radius 0", met((ORIGIN, 0.0), from(0.0, 3.0)), REFUSED, Equal, Fails),
        case("A32", "radius -1", met((ORIGIN, -1.0), from(0.0, 3.0)), REFUSED, Equal, Fails),
        case("A33", "a scene of size 1e-170, whose squares vanish",
            met((ORIGIN, 1e-170), from(0.0, 3e-170)), REFUSED, Equal, Fails),
        case("A34", "a scene of size 1e160, whose squares are infinite",
            met((ORIGIN, 1e160), from(0.0, 3e160)), REFUSED, Equal, Fails),
        case("A35", "direction 0, past the constructor",
            unchecked(([0.0, 0.0, 3.0], ORIGIN)), MISS, Equal, Fails),
        case("A36", "infinite radius", met((ORIGIN, f64::INFINITY), from(0.0, 3.0)), REFUSED, Equal, Fails),
        case("A37", "an origin of NaN, past the constructor",
            unchecked(from(f64::NAN, 3.0)), MISS, Equal, Holds),
        case("A38", "an infinite direction, past the constructor",
            unchecked(([0.0, 0.0, 3.0], [0.0, 0.0, f64::NEG_INFINITY])), MISS, Equal, Holds),
        case("A39", "a direction with two negative zeros",
            met(UNIT, ([0.0, 0.0, 3.0], [-0.0, -0.0, -1.0])), 2.0, Equal, Holds),
        Case::new("A40", "seen from inside: cosine between normal and direction", -1.0, Equal, facing)
            .protocol(Fails, outwards),
        Case::new("A41", "past the sphere: the root drawn before its sign is tested",
            MISS, Equal, meeting(unit(), past))
            .protocol(Fails, (-b - discriminant.sqrt()) / (2.0 * a)),
    ];
    cases.extend(lengths.map(long_or_short));
    cases
}
