//! Far, huge and tiny spheres, tangent rays, and rays from inside.

use a02_math::{Direction, Point3};
use common::{ArgumentError, Color};
use measure::extremes::Protocol::{Fails, Holds};
use measure::extremes::{Bound, Case, Outcome, Protocol};

use super::{EPSILON, Line, MISS, REFUSED, Triple, any_ray, meeting, point, raw_ray, unit_ray};
use crate::{Geometry, Interval, Sphere, World, protocol};

const AT_ORIGIN: (Triple, f64) = ([0.0; 3], 1.0);
const DOWN_Z: Triple = [0.0, 0.0, -1.0];

/// Error bound of the renderer's formula: four rounding errors of the distance
/// to the centre, or of the radius if that is greater, over the cosine.
fn stable(length: f64, cos: f64) -> Bound {
    Bound::Absolute(4.0 * EPSILON * length / cos)
}

fn case(
    id: &'static str,
    what: &str,
    (c, r): (Triple, f64),
    line: Line,
    exact: impl Into<Outcome>,
    bound: Bound,
    says: Protocol,
) -> Case {
    let ray = any_ray(line);
    let [o, d] = [ray.origin().to_glam(), ray.direction().to_glam()].map(|v| v.to_array());
    Case::new(
        id,
        what,
        exact,
        bound,
        meeting(Sphere::new(point(c), r), line),
    )
    .protocol(says, protocol::sphere(&c, r, &o, &d))
}

/// The unit sphere from 3 away along a direction of another length: distances.
fn long_or_short(id: &'static str, length: f64, says: Protocol) -> Case {
    let line = ([0.0, 0.0, 3.0], [0.0, 0.0, -length]);
    let raw = protocol::sphere(&[0.0; 3], 1.0, &line.0, &line.1);
    let (c, r) = AT_ORIGIN;
    let ours = meeting(Sphere::new(point(c), r), line);
    let what = format!("distance 2 along a direction of length {length:e}");
    Case::new(id, what, 2.0, Bound::Ulps(1.0), ours).protocol(says, raw.map(|t| t * length))
}

/// A ray that no scene contains, passed directly to the shape.
fn unchecked(id: &'static str, what: &str, line: Line, says: Protocol) -> Case {
    let (c, r) = AT_ORIGIN;
    let ours = Sphere::new(point(c), r).map(|s| super::first(&s, &raw_ray(line)));
    Case::new(id, what, MISS, Bound::Equal, ours)
        .protocol(says, protocol::sphere(&c, r, &line.0, &line.1))
}

pub fn cases() -> Vec<Case> {
    let mut cases = far_and_small().to_vec();
    cases.extend(huge());
    cases.extend(on_the_surface());
    cases.extend(touched());
    cases.extend([
        long_or_short("A23", 1e-200, Fails),
        long_or_short("A24", 1e-163, Fails),
        long_or_short("A25", 1e-160, Fails),
        long_or_short("A26", 1e-155, Fails),
        long_or_short("A27", 1e4, Fails),
        long_or_short("A28", 1e150, Fails),
        long_or_short("A29", 1e155, Fails),
        long_or_short("A30", 1e200, Fails),
    ]);
    cases.extend(no_spheres_and_no_rays());
    cases
}

#[rustfmt::skip]
fn far_and_small() -> [Case; 8] {
    let from = |x: f64, z: f64| ([x, 0.0, z], DOWN_Z);
    [
        case("A01", "radius 1 from 1e8 away",
            AT_ORIGIN, from(0.0, 1e8), 99_999_999.0, stable(1e8, 1.0), Fails),
        case("A02", "radius 1 from 1e12 away",
            AT_ORIGIN, from(0.0, 1e12), 999_999_999_999.0, stable(1e12, 1.0), Fails),
        case("A03", "two radii beside it, from 1e12 away",
            AT_ORIGIN, from(2.0, 1e12), MISS, Bound::Equal, Fails),
        case("A04", "half a radius beside it, from 1e9 away",
            AT_ORIGIN, from(1.5, 1e9), MISS, Bound::Equal, Fails),
        case("A05", "radius 1 from 3.7e9 away along (1, 2, 3)",
            AT_ORIGIN, ([-1e9, -2e9, -3e9], [1.0, 2.0, 3.0]),
            3_741_657_385.773_941_5, stable(3.742e9, 1.0), Fails),
        case("A06", "radius 0.7 at (0.1, 0.2, 0.3) from 1e8 away",
            ([0.1, 0.2, 0.3], 0.7), ([0.1, 0.2, 1e8 + 0.3], DOWN_Z),
            99_999_999.3, stable(1e8, 1.0), Fails),
        case("A07", "radius 1e-12 from 1 away",
            ([0.0; 3], 1e-12), from(0.0, 1.0), 0.999_999_999_999, stable(1.0, 1.0), Fails),
        case("A08", "radius 1e-9 from 1 away, half a radius off the middle",
            ([0.0; 3], 1e-9), from(5e-10, 1.0), 0.999_999_999_133_974_6, stable(1.0, 0.866), Fails),
    ]
}

#[rustfmt::skip]
fn huge() -> [Case; 3] {
    let ground = |r: f64| ([0.0, -r, 0.0], r);
    let line = ([0.3, 1.1, 0.7], [0.1, -1.0, 0.2]);
    let cos = 0.976;
    [
        case("A09", "ground of radius 1e6, seen from 1.1 above",
            ground(1e6), line, 1.127_165_104_032_250_6, stable(1e6, cos), Holds),
        case("A10", "ground of radius 1e9, seen from 1.1 above",
            ground(1e9), line, 1.127_164_584_775_332_4, stable(1e9, cos), Holds),
        case("A11", "ground of radius 1e12, seen from 1.1 above: use a plane",
            ground(1e12), line, 1.127_164_584_256_075_8, stable(1e12, cos), Holds),
    ]
}

#[rustfmt::skip]
fn on_the_surface() -> [Case; 8] {
    let up_z = [0.0, 0.0, 1.0];
    let small = ([0.0; 3], 1e-4);
    [
        case("A12", "on the sphere, looking out",
            AT_ORIGIN, ([0.0, 0.0, 1.0], up_z), MISS, Bound::Equal, Holds),
        case("A13", "on the sphere, looking in",
            AT_ORIGIN, ([0.0, 0.0, 1.0], DOWN_Z), 2.0, Bound::Ulps(1.0), Holds),
        case("A14", "the same, a scene of size 1e-4",
            small, ([0.0, 0.0, 1e-4], DOWN_Z), 2e-4, Bound::Ulps(2.0), Fails),
        case("A15", "1e-12 below the surface, looking out",
            AT_ORIGIN, ([0.0, 0.0, 1.0 - 1e-12], up_z),
            9.999_778_782_798_785e-13, stable(1.0, 1.0), Fails),
        case("A16", "1e-9 above the surface, looking down",
            AT_ORIGIN, ([0.0, 0.0, 1.0 + 1e-9], DOWN_Z),
            1.000_000_082_740_371e-9, stable(1.0, 1.0), Fails),
        case("A17", "in the centre",
            AT_ORIGIN, ([0.0; 3], [1.0, 2.0, 2.0]), 1.0, Bound::Equal, Holds),
        case("A18", "behind the eye",
            AT_ORIGIN, ([0.0, 0.0, -3.0], DOWN_Z), MISS, Bound::Equal, Holds),
        facing_from_inside(),
    ]
}

/// The protocol's normal points outwards, also for an eye inside.
fn facing_from_inside() -> Case {
    let line = ([0.0; 3], [0.0, 0.0, 1.0]);
    let ours = || -> Result<_, ArgumentError> {
        let world = World::new(Color::BLACK)?.with(Sphere::new(Point3::ORIGIN, 1.0)?, ());
        let ray = unit_ray(line)?;
        let hit = world.hit(&ray, Interval::AHEAD);
        Ok(hit.map(|(hit, ())| hit.normal.dot(ray.direction())))
    };
    let outwards = Sphere::new(Point3::ORIGIN, 1.0).map(|sphere| {
        let (ray, within) = (raw_ray(line), Interval::AHEAD);
        let hit = sphere.hit(&ray, within);
        hit.map(|hit| hit.normal.dot(ray.direction()))
    });
    let what = "seen from inside: cosine between normal and direction";
    Case::new("A40", what, -1.0, Bound::Equal, ours()).protocol(Fails, outwards)
}

#[rustfmt::skip]
fn touched() -> [Case; 5] {
    let along_x = |x: f64, y: f64| ([x, y, 0.0], [1.0, 0.0, 0.0]);
    let next = 1.0_f64.next_up();
    let below = 1.0_f64.next_down();
    let past = any_ray(along_x(-5.0, 2.0));
    let [o, d] = [past.origin().to_glam(), past.direction().to_glam()].map(|v| v.to_array());
    let [a, b, discriminant] = protocol::sphere_terms(&[0.0; 3], 1.0, &o, &d);
    [
        case("A19", "tangent: touching is meeting",
            AT_ORIGIN, along_x(-5.0, 1.0), 5.0, Bound::Equal, Holds),
        case("A20", "one unit in the last place beside the tangent",
            AT_ORIGIN, along_x(-5.0, next), MISS, Bound::Equal, Fails),
        case("A21", "half a unit in the last place below the tangent",
            AT_ORIGIN, along_x(-5.0, below), 4.999_999_985_098_839, Bound::Ulps(2.0), Fails),
        case("A22", "1e-9 beside the tangent, from 1e6 away",
            AT_ORIGIN, along_x(-1e6, 1.0 + 1e-9), MISS, Bound::Equal, Fails),
        Case::new("A41", "past the sphere: the root drawn before its sign is tested", MISS, Bound::Finite, meeting(Sphere::new(Point3::ORIGIN, 1.0), along_x(-5.0, 2.0)))
            .protocol(Fails, (-b - discriminant.sqrt()) / (2.0 * a)),
    ]
}

#[rustfmt::skip]
fn no_spheres_and_no_rays() -> [Case; 9] {
    let line = ([0.0, 0.0, 3.0], DOWN_Z);
    let scaled = |s: f64| ([0.0, 0.0, 3.0 * s], DOWN_Z);
    [
        case("A31", "radius 0", ([0.0; 3], 0.0), line, REFUSED, Bound::Equal, Fails),
        case("A32", "radius -1", ([0.0; 3], -1.0), line, REFUSED, Bound::Equal, Fails),
        case("A33", "a scene of size 1e-170, whose squares vanish",
            ([0.0; 3], 1e-170), scaled(1e-170), REFUSED, Bound::Equal, Fails),
        case("A34", "a scene of size 1e160, whose squares are infinite",
            ([0.0; 3], 1e160), scaled(1e160), REFUSED, Bound::Equal, Fails),
        unchecked("A35", "direction 0, past the constructor", ([0.0, 0.0, 3.0], [0.0; 3]), Fails),
        case("A36", "infinite radius",
            ([0.0; 3], f64::INFINITY), line, REFUSED, Bound::Equal, Fails),
        unchecked("A37", "an origin of NaN, past the constructor",
            ([f64::NAN, 0.0, 3.0], DOWN_Z), Holds),
        unchecked("A38", "an infinite direction, past the constructor",
            ([0.0, 0.0, 3.0], [0.0, 0.0, f64::NEG_INFINITY]), Holds),
        case("A39", "a direction with two negative zeros",
            AT_ORIGIN, ([0.0, 0.0, 3.0], [-0.0, -0.0, -1.0]), 2.0, Bound::Equal, Holds),
    ]
}
