//! Lamps of many colours, compared with the solution.

use crate::prelude::*;
use crate::solutions::fading_light::fading_light as solution;

pub fn check(check: &mut Check, light: impl Fn(Color, Point3, Point3) -> Arriving + Sync) {
    compare_lights(
        check,
        "lamp {} at {}",
        &([1.0, 0.5, 0.25], LAMP),
        |r| (channels(r), r.triple(5.0)),
        |(c, lamp), p| solution(color(c), point(lamp), p),
        |(c, lamp), p| light(color(c), point(lamp), p),
    );
    let lamp = |p| light(Color::gray(2.5), point([0.2, 2.2, 1.5]), p);
    check.picture(lit(scenes::phong(), lamp));
}

pub const VARIANTS: &[Variant] = &[wrong("twice as far away is a quarter, not half", |c| {
    check(c, |color, lamp, p| {
        solution(color * (lamp - p).magnitude(), lamp, p)
    });
})];
