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
    let lamp = |p| light(Color::WHITE, point([4.0; 3]), p);
    check.scene(&stage(), "phong", lit(scenes::phong(), lamp));
}

pub const VARIANTS: &[Variant] = &[right("divided by the distance", |c| {
    check(c, |color, lamp, p| {
        let mut light = lesson(color, lamp, p)?;
        light.distance = (lamp - p).magnitude();
        light.direction = (lamp - p) * (1.0 / light.distance);
        Some(light)
    });
})];
