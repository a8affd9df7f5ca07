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
    show_in(check, |p| {
        light(Color::gray(2.5), point([0.2, 2.2, 1.5]), p)
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("the area grows with the square of the distance", |c| {
        check(c, |color, lamp, p| {
            solution(color * (lamp - p).magnitude(), lamp, p)
        });
    }),
    wrong("nearer than 1, the light is brighter than at 1", |c| {
        check(c, |color, lamp, p| {
            let way = lamp - p;
            solution(color * way.dot(way).min(1.0), lamp, p)
        });
    }),
];
