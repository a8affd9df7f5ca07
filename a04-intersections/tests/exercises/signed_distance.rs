//! Normals of whole numbers, and steps along and across them.

use a02_math::{Normal3, Point3, Vector3};
use measure::extremes::Bound;
use testing::exercise::{Check, Random};

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

    let mut steps = |a: Point3, n: Vector3, length: f64, k: f64, along: Vector3| {
        for (side, sign) in [("", 1.0), (", on the other side", -1.0)] {
            let p = a + n * k + along;
            let got = signed_distance(a, (n * sign).as_normal(), p);
            let what = format!("{k} normals of length {length:.3} away{side}");
            check.expect(what, sign * k * length, Bound::Absolute(1e-12), got);
        }
    };
    // Both steps run along the plane.
    let (one, other) = (Vector3::new(1.0, 2.0, 0.0), Vector3::new(0.0, 2.0, 1.0));
    for k in -4..=4 {
        let along = one * 5.0 + other * -3.0;
        steps(a, Vector3::new(2.0, -1.0, 2.0), 3.0, f64::from(k), along);
    }
    let mut random = Random::new(1);
    let mut whole = || {
        let [x, y, z] = [(); 3].map(|()| f64::from(random.below(19)) - 9.0);
        Vector3::new(x, y, z)
    };
    for k in [2.0, -1.5, 0.25, -3.0].into_iter().cycle().take(40) {
        let (a, n) = (Point3::ORIGIN + whole(), whole());
        let [x, y, z] = n.to_glam().to_array();
        let squared = x * x + y * y + z * z;
        if squared > 0.0 {
            steps(a, n, squared.sqrt(), k, n.cross(whole()));
        }
    }
}
