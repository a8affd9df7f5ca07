//! Far lights, compared with the lesson's.

use crate::prelude::*;

pub fn directional_light(color: Color, direction: Vector3) -> Option<Illumination> {
    let sun = DirectionalLight::new(color, direction);
    sun.ok()?.illumination(Point3::ORIGIN)
}

pub fn check(check: &mut Check, yours: fn(Color, Vector3) -> Arriving) {
    compare_lights(
        check,
        "light {} that travels along {}",
        &([1.0, 0.5, 0.25], [0.0, -2.0, 0.0]),
        |r| {
            let length = r.scale();
            (channels(r), r.triple(5.0).map(|x| x * length))
        },
        &|(c, d), _| directional_light(color(c), vector(d)),
        &|(c, d), _| yours(color(c), vector(d)),
    );
    let sun = |_| yours(Color::WHITE, vector([-1.0; 3]));
    let picture = lit(scenes::phong_directional(), "DirectionalLight", sun);
    check.scene(&stage(), "phong-directional", picture);
}

variants! { check:
    yours => directional_light;
    right "divided by the length" => |color, d| {
        let mut light = directional_light(color, d)?;
        light.direction = d * (-1.0 / d.magnitude());
        Some(light)
    };
}
