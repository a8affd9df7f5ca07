//! Cones of light of all angles, compared with the lesson's.

use std::f64::consts::PI;

use crate::prelude::*;

pub fn spot_light(
    color: Color,
    lamp: Point3,
    axis: Vector3,
    half_angle: f64,
    point: Point3,
) -> Option<Illumination> {
    let spot = SpotLight::new(color, lamp, axis, half_angle);
    spot.ok()?.illumination(point)
}

pub fn check(
    check: &mut Check,
    yours: &(dyn Fn(Color, Point3, Vector3, f64, Point3) -> Arriving + Sync),
) {
    for half_angle in [1.0, PI] {
        compare_lights(
            check,
            "light {} at {}, axis {}, half angle {}",
            &([1.0, 0.5, 0.25], LAMP, [0.0, -1.0, 0.0], half_angle),
            |r| {
                let [lamp, axis] = [(); 2].map(|()| r.triple(5.0));
                (channels(r), lamp, axis, r.between(0.05, 3.1))
            },
            &|(c, lamp, axis, angle), p| spot_light(color(c), point(lamp), unit(axis), angle, p),
            &|(c, lamp, axis, angle), p| yours(color(c), point(lamp), unit(axis), angle, p),
        );
    }
    let spot = |p| yours(Color::WHITE, point([4.0; 3]), unit([-1.0; 3]), PI / 14.0, p);
    let picture = lit(scenes::phong_spot(), "SpotLight", spot);
    check.scene(&stage(), "phong-spot", picture);
}

/// The light where this function accepts the angle of the point and the half angle.
fn textbook(c: &mut Check, accepts: fn(f64, f64) -> bool) {
    check(c, &|color, lamp, axis, half_angle, p| {
        let light = PointLight::new(color, lamp).ok()?.illumination(p)?;
        let angle = libm::acos(axis.dot(-light.direction).clamp(-1.0, 1.0));
        accepts(angle, half_angle).then_some(light)
    });
}

variants! { textbook:
    yours => &spot_light;
    right "angles" => |angle, half| angle <= half;
    wrong "a wide cone shines behind the lamp, too" => |angle, half| angle <= half.min(PI / 2.0);
}
