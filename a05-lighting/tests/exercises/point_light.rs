//! Lamps, compared with the lesson's.

use crate::prelude::*;

pub fn point_light(color: Color, lamp: Point3, point: Point3) -> Option<Illumination> {
    PointLight::new(color, lamp).ok()?.illumination(point)
}

pub fn check(check: &mut Check, yours: fn(Color, Point3, Point3) -> Arriving) {
    compare_lights(
        check,
        "light {} at {}",
        &([1.0, 0.5, 0.25], LAMP),
        |r| (channels(r), r.triple(5.0)),
        &|(c, lamp), p| point_light(color(c), point(lamp), p),
        &|(c, lamp), p| yours(color(c), point(lamp), p),
    );
    let lamp = |p| yours(Color::WHITE, point([4.0; 3]), p);
    let picture = lit(scenes::phong(), "PointLight", lamp);
    check.scene(&stage(), "phong", picture);
}

variants! { check:
    yours => point_light;
    right "divided by the distance" => |color, lamp, p| {
        let mut light = point_light(color, lamp, p)?;
        light.distance = (lamp - p).magnitude();
        light.direction = (lamp - p) * (1.0 / light.distance);
        Some(light)
    };
}
