//! Planes anywhere, compared with the lesson's.

use crate::prelude::*;

/// Down to the floor, up from it, up to it, parallel to it, and in it.
const SIMPLE: [[[f64; 3]; 2]; 5] = [
    [[0.0, 0.0, 0.0], [0.0, -0.5, 0.0]],
    [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    [[0.0, -3.0, 0.0], [0.0, 1.0, 1.0]],
    [[0.0, 0.0, 0.0], [3.0, 0.0, 1.0]],
    [[4.0, -1.0, 2.0], [3.0, 0.0, 1.0]],
];

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Normal3) -> Result<G, ArgumentError>,
) {
    let floor = ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
    compare(
        check,
        "plane through {}, normal {}",
        (floor, &SIMPLE),
        |r| (r.triple(5.0), r.triple(5.0)),
        |(a, n)| Plane::new(point(a), vector(n).as_normal()),
        |(a, n)| new(point(a), vector(n).as_normal()),
    );
    scene(
        check,
        "scene-1",
        a04_intersections::scenes::scene_1,
        new(point(floor.0), vector(floor.1).as_normal()),
    );
}

/// A `t` from the distance of the origin along the normal, the approach in one step along the
/// ray, and the length of that step; NaN is no hit.
fn variant(c: &mut Check, t: fn(f64, f64, f64) -> f64) {
    check(c, move |a, n| {
        let n = n.unit("n")?;
        own(move |ray: &Ray, within| {
            // In the form n · p + k = 0.
            let k = -n.dot(a - Point3::ORIGIN);
            let (ahead, d) = (-n.dot(ray.origin() - Point3::ORIGIN) - k, ray.direction());
            let t = t(ahead, n.dot(d), d.magnitude());
            within.contains(t).then(|| Hit::new(t, n))
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    right("the plane as n · p + k = 0", |c| {
        variant(c, |ahead, approach, _| ahead / approach)
    }),
    wrong(
        "a ray is parallel where d · n is 0; small says nothing, as d has any length",
        |c| {
            variant(c, |ahead, approach, _| {
                if approach.abs() > 1e-6 {
                    ahead / approach
                } else {
                    f64::NAN
                }
            });
        },
    ),
    wrong("a plane is seen from its far side, too", |c| {
        variant(c, |ahead, approach, _| {
            if approach < 0.0 {
                ahead / approach
            } else {
                f64::NAN
            }
        });
    }),
    wrong("t counts steps of the direction, not lengths", |c| {
        variant(c, |ahead, approach, length| ahead / approach * length);
    }),
    wrong("the normal of a shape does not turn to the ray", |c| {
        check(c, |a, n| {
            let plane = Plane::new(a, n)?;
            own(move |ray: &Ray, within| {
                let Hit { t, normal, .. } = plane.hit(ray, within)?;
                let sign = -normal.dot(ray.direction()).signum();
                Some(Hit::new(t, normal * sign))
            })
        });
    }),
];
