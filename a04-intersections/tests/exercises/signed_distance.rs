//! Points on both sides of planes, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Point3, Normal3, Point3) -> f64) {
    let (a, up) = ([7.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
    let above = [[0.0, 0.0, 0.0], [0.0, -3.0, 5.0], [-4.0, -1.0, 9.0]].map(|p| [a, up, p]);
    let long = [[0.0; 3], [0.0, 0.0, 2.0], [1.0, 1.0, 3.0]];
    check.compare(
        "a, n and p {}",
        above.into_iter().chain([long]),
        random(|r| [(); 3].map(|()| r.triple(9.0))),
        [signed_distance, yours],
        |distance, [a, n, p]| distance(point(a), vector(n).as_normal(), point(p)),
    );
}

variants! { check:
    yours => signed_distance;
    wrong "n may have any length: divide by it" => |a, n, p| (p - a).dot(n);
    wrong "n · n is the length squared" => |a, n, p| (p - a).dot(n) / n.dot(n);
    wrong "the distance from the plane is not that from a" => |a, n, p| {
        Vector3::magnitude(p - a).copysign((p - a).dot(n))
    };
}
