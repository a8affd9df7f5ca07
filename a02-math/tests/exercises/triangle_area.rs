//! Triangles, also flat and far away, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Point3, Point3, Point3) -> f64) {
    check.exactly("loses digits where a triangle is flat or far away");
    let [o, x, y] = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
    check.compare(
        "corners {}, {} and {}",
        [(o, x, y), (o, x, [2.0, 1.0 / 256.0, 0.0])],
        random(|r| {
            let far = f64::from(r.below(2)) * 1e6;
            let mut corner = || r.triple(9.0).map(|x| x + far);
            (corner(), corner(), corner())
        }),
        [triangle_area, yours],
        |triangle_area, (a, b, c)| triangle_area(point(a), point(b), point(c)),
    );
}

variants! { check:
    yours => triangle_area;
    right "from another corner" => |p, q, r| (p - r).cross(q - r).magnitude() * 0.5;
    wrong "a triangle is half of the parallelogram" => |p, q, r| 2.0 * triangle_area(p, q, r);
    wrong "Heron's sides lose the height of a flat triangle" => |p, q, r| {
        let [a, b, c] = [r - q, p - r, q - p].map(Vector3::magnitude);
        let s = (a + b + c) / 2.0;
        (s * (s - a) * (s - b) * (s - c)).sqrt()
    };
    wrong "sides from the origin lose digits far away" => |p, q, r| {
        let [p, q, r] = [p, q, r].map(|corner| corner - Point3::ORIGIN);
        (p.cross(q) + q.cross(r) + r.cross(p)).magnitude() / 2.0
    };
}
