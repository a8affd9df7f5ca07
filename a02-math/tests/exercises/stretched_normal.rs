//! Normals and stretches of all kinds, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Normal3, [f64; 3]) -> Option<Normal3>) {
    let numbers = |n: Option<Normal3>| n.map(|n| n.to_glam().to_array());
    let [n, zero] = [[1.0, 1.0, 0.0], [0.0; 3]];
    check.compare(
        "n = {}, factors {}",
        [(n, [2.0, 1.0, 1.0]), (n, [1.0, 0.0, 1.0]), (zero, n)],
        random(|r| {
            let scale = r.scale();
            let mut factor = || (r.between(0.1, 9.0) - 4.005) * scale;
            let factors = [factor(), factor(), factor()];
            (r.triple(1.0), factors)
        }),
        [stretched_normal, yours],
        |stretched_normal, (n, factors)| numbers(stretched_normal(vector(n).as_normal(), factors)),
    );
}

variants! { check:
    yours => stretched_normal;
    wrong "a normal is divided where points are multiplied" => |n, factors| {
        stretched_normal(n, factors.map(|f| 1.0 / f))
    };
    wrong "a mirror turns the normal, too" => |n, factors| {
        stretched_normal(n, factors.map(f64::abs))
    };
    wrong "the normal is to have length 1 again" => |n, [x, y, z]| {
        let divided = Normal3::new(n.x() / x, n.y() / y, n.z() / z);
        stretched_normal(n, [x, y, z]).map(|_| divided)
    };
}
