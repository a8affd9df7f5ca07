//! Far lights, compared with the lesson's.

use crate::prelude::*;
use crate::solutions::directional_light::directional_light as lesson;

pub fn check(check: &mut Check, light: impl Fn(Color, Vector3) -> Arriving + Sync) {
    compare_lights(
        check,
        "light {} that travels along {}",
        &([1.0, 0.5, 0.25], [0.0, -2.0, 0.0]),
        |r| {
            let length = r.scale();
            (channels(r), r.triple(5.0).map(|x| x * length))
        },
        |(c, d), _| lesson(color(c), vector(d)),
        |(c, d), _| light(color(c), vector(d)),
    );
    let sun = |_| light(Color::WHITE, vector([-1.0; 3]));
    let picture = lit(scenes::phong_directional(), sun);
    check.scene(&stage(), "phong-directional", picture);
}

pub const VARIANTS: &[Variant] = &[right("divided by the length", |c| {
    check(c, |color, d| {
        let mut light = lesson(color, d)?;
        light.direction = d * (-1.0 / d.magnitude());
        Some(light)
    });
})];
