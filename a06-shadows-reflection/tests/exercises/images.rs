//! Lamps between mirrors, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: &dyn Fn(f64, f64, u32) -> [f64; 2]) {
    check.compare(
        "mirrors {} apart, lamp at {}, after {} reflections",
        [0, 1, 2, 3].map(|n| (10.0, 3.0, n)),
        random(|r| {
            let width = r.between(1.0, 20.0);
            (width, r.between(0.0, width), r.below(12))
        }),
        [&images as _, yours],
        |images, (width, lamp, n)| images(width, lamp, n),
    );
}

variants! { steps:
    yours => &images;
    wrong "a mirror shows the image in the other one" => |width, [left, right]| {
        [-left, 2.0 * width - right]
    };
    wrong "a mirror at x = m moves x to 2m - x" => |width, [left, right]| [-right, width - left];
    wrong "both images are replaced at once" => |width, [_, right]| [-right, 2.0 * width + right];
}

/// Images of which each step makes the next ones.
fn steps(c: &mut Check, step: fn(f64, [f64; 2]) -> [f64; 2]) {
    check(c, &|width, lamp, n| {
        (0..n).fold([lamp; 2], |images, _| step(width, images))
    });
}
