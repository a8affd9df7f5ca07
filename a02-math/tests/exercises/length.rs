//! Vectors of all lengths, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: &dyn Fn(f64, f64, f64) -> f64) {
    let simple = [(3.0, 4.0), (0.0, -2.0), (0.0, 0.0), (3e200, 4e200)];
    check.compare(
        "the vector ({}, {}, {})",
        simple.map(|(y, z)| (0.0, y, z)),
        random(|r| {
            let scale = [1e-299, 1e-160, 1.0, 1e160, 1e299][r.below(5) as usize];
            let [x, y, z] = r.triple(9.0).map(|x| x * scale);
            (x, y, z)
        }),
        [&length as _, yours],
        |length, (x, y, z)| length(x, y, z),
    );
}

variants! { divided:
    yours => &length;
    wrong "squares overflow" => |_, _, _| 1.0;
    wrong "the largest coordinate may be negative" => |x, y, z| x.max(y).max(z);
    wrong "0 / 0 is not a number" => |x, y, z| x.abs().max(y.abs()).max(z.abs());
}

/// Divided by this number first, and multiplied by it afterwards.
fn divided(c: &mut Check, by: fn(f64, f64, f64) -> f64) {
    check(c, &|x, y, z| {
        let by = by(x, y, z);
        let [x, y, z] = [x / by, y / by, z / by];
        by * (x * x + y * y + z * z).sqrt()
    });
}
