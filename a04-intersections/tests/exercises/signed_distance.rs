//! A normal of length 3 and steps across it, all of them whole numbers.

use a02_math::{Normal3, Point3, Vector3};
use measure::extremes::Bound;
use testing::exercise::Check;

pub fn check(check: &mut Check, signed_distance: impl Fn(Point3, Normal3, Point3) -> f64) {
    let up = Normal3::new(0.0, 1.0, 0.0);
    let a = Point3::new(7.0, -1.0, 0.0);
    for (p, exact) in [
        (Point3::ORIGIN, 1.0),
        (Point3::new(0.0, -3.0, 5.0), -2.0),
        (Point3::new(-4.0, -1.0, 9.0), 0.0),
    ] {
        let what = format!("from the plane y = -1 to {}", p.to_glam());
        check.expect(what, exact, Bound::Equal, signed_distance(a, up, p));
    }

    // Both steps run along the plane.
    let n = Normal3::new(2.0, -1.0, 2.0);
    let (one, other) = (Vector3::new(1.0, 2.0, 0.0), Vector3::new(0.0, 2.0, 1.0));
    for k in -4..=4 {
        let exact = 3.0 * f64::from(k);
        let way = Vector3::from(n) * f64::from(k) + one * 5.0 + other * -3.0;
        let got = signed_distance(a, n, a + way);
        let what = format!("{k} normals of length 3 away");
        check.expect(what, exact, Bound::Absolute(1e-13), got);
        let got = signed_distance(a, -n, a + way);
        let what = format!("{k} normals of length 3 away, on the other side");
        check.expect(what, -exact, Bound::Absolute(1e-13), got);
    }
}
