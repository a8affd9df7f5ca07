//! Triangles whose sides are whole numbers, near and far from the origin.

use a02_math::{Point3, Vector3};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

pub fn check(check: &mut Check, area: impl Fn(Point3, Point3, Point3) -> f64) {
    let mut random = Random::new(1);
    let sides = [
        ([3.0, 0.0, 0.0], [0.0, 4.0, 0.0]),
        // In a plane aslant: the cross product is (1, 2, 2) times 3 or 6.
        ([2.0, 1.0, -2.0], [-2.0, 2.0, -1.0]),
        ([2.0, 1.0, -2.0], [-4.0, 4.0, -2.0]),
        ([2.0, 1.0, -2.0], [8.0, 4.0, -8.0]),
        // So flat that all sides together say nothing of the area.
        ([1.0, 0.0, 0.0], [0.5, 1.0 / 1_048_576.0, 0.0]),
    ];
    let mut whole = || std::array::from_fn(|_| f64::from(random.below(41)) - 20.0);
    let more = std::iter::repeat_with(|| (whole(), whole())).take(40);
    let far = Point3::new(1_048_576.0, -2_097_152.0, 524_288.0);
    for (ab, ac) in sides.into_iter().chain(more) {
        for (place, a) in [("at the origin", Point3::ORIGIN), ("far away", far)] {
            let [b, c] = [ab, ac].map(|side| a + Vector3::from_glam(side.into()));
            let mut corners = |order: &str, [a, b, c]: [Point3; 3]| {
                let what = format!("area {place}, corners {order}, a to b {ab:?}, a to c {ac:?}");
                let bound = Bound::Ulps(4.0);
                check.expect(what, half_parallelogram(ab, ac), bound, area(a, b, c));
            };
            corners("a, b, c", [a, b, c]);
            corners("c, b, a", [c, b, a]);
            corners("b, c, a", [b, c, a]);
        }
    }
}

/// Exact up to the root: products and sums of these whole numbers and fractions are.
fn half_parallelogram([x, y, z]: [f64; 3], [i, j, k]: [f64; 3]) -> f64 {
    let [across, beside, along] = [y * k - z * j, z * i - x * k, x * j - y * i];
    (across * across + beside * beside + along * along).sqrt() / 2.0
}
