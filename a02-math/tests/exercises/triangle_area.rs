//! Triangles whose sides are whole numbers, near and far from the origin.

use a02_math::{Point3, Vector3};
use measure::extremes::Bound;
use testing::exercise::Check;

pub fn check(check: &mut Check, area: impl Fn(Point3, Point3, Point3) -> f64) {
    let far = Point3::new(1_048_576.0, -2_097_152.0, 524_288.0);
    for (place, a) in [("at the origin", Point3::ORIGIN), ("far away", far)] {
        for (ab, ac, exact) in [
            ([3.0, 0.0, 0.0], [0.0, 4.0, 0.0], 6.0),
            // In a plane aslant: the cross product is (1, 2, 2) times 3 or 6.
            ([2.0, 1.0, -2.0], [-2.0, 2.0, -1.0], 4.5),
            ([2.0, 1.0, -2.0], [-4.0, 4.0, -2.0], 9.0),
            ([2.0, 1.0, -2.0], [8.0, 4.0, -8.0], 0.0),
            // So flat that all sides together say nothing of the area.
            (
                [1.0, 0.0, 0.0],
                [0.5, 1.0 / 1_048_576.0, 0.0],
                0.5 / 1_048_576.0,
            ),
        ] {
            let [ab, ac] = [ab, ac].map(|xyz: [f64; 3]| Vector3::from_glam(xyz.into()));
            let (b, c) = (a + ab, a + ac);
            let mut corners = |order: &str, [a, b, c]: [Point3; 3]| {
                let what = format!(
                    "{place}, corners {order}, sides {} and {}",
                    ab.to_glam(),
                    ac.to_glam()
                );
                check.expect(what, exact, Bound::Ulps(4.0), area(a, b, c));
            };
            corners("a, b, c", [a, b, c]);
            corners("c, b, a", [c, b, a]);
            corners("b, c, a", [b, c, a]);
        }
    }
}
