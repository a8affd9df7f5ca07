//! Lamps, compared with the lesson's.

use crate::prelude::*;
use crate::solutions::point_light::point_light as lesson;

pub fn check(check: &mut Check, light: impl Fn(Color, Point3, Point3) -> Arriving + Sync) {
    compare_lights(
        check,
        "light {} at {}",
        &([1.0, 0.5, 0.25], LAMP),
        |r| (channels(r), r.triple(5.0)),
        |(c, lamp), p| lesson(color(c), point(lamp), p),
        |(c, lamp), p| light(color(c), point(lamp), p),
    );
    scene_in(check, "phong", a05_lighting::scenes::phong(), |p| {
        light(Color::WHITE, point([4.0; 3]), p)
    });
}

pub const VARIANTS: &[Variant] = &[
    right("divided by the distance", |c| {
        check(c, |color, lamp, p| {
            let distance = (lamp - p).magnitude();
            let direction = (lamp - p) * (1.0 / distance);
            (distance > 0.0).then_some(Illumination {
                color,
                direction,
                distance,
            })
        });
    }),
    wrong("in the light there is no direction", |c| {
        check(c, |color, lamp, p| {
            let dark = Illumination {
                color,
                ..Illumination::default()
            };
            lesson(color, lamp, p).or(Some(dark))
        });
    }),
];
