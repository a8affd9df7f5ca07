//! Lamps of many colours, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Color, Point3, Point3) -> Arriving) {
    compare_lights(
        check,
        "lamp {} at {}",
        &([1.0, 0.5, 0.25], LAMP),
        |r| (channels(r), r.triple(5.0)),
        &|(c, lamp), p| fading_light(color(c), point(lamp), p),
        &|(c, lamp), p| yours(color(c), point(lamp), p),
    );
    let lamp = |p| yours(Color::gray(2.5), point([0.2, 2.2, 1.5]), p);
    check.picture(lit(scenes::phong(), "", lamp));
}

variants! { check:
    yours => fading_light;
    wrong "twice as far away is a quarter, not half" => |color, lamp, p| {
        fading_light(color * (lamp - p).magnitude(), lamp, p)
    };
}
