//! Spots with narrow and wide rims, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Color, Point3, Vector3, [f64; 2], Point3) -> Arriving) {
    compare_lights(
        check,
        "light {} at {}, which shines along {}, inner and outer angle {}",
        &([1.0, 0.5, 0.25], LAMP, [0.0, -2.0, 0.0], [0.5, 1.0]),
        |r| {
            let inner = r.between(0.0, 1.4);
            let angles = [inner, inner + r.between(0.05, 1.6)];
            (channels(r), r.triple(5.0), r.triple(5.0), angles)
        },
        &|(c, lamp, d, angles), p| soft_spot(color(c), point(lamp), vector(d), angles, p),
        &|(c, lamp, d, angles), p| yours(color(c), point(lamp), vector(d), angles, p),
    );
    let (lamp, inwards) = (point([4.0; 3]), vector([-1.0; 3]));
    let yours = |p| yours(Color::WHITE, lamp, inwards, [0.1, 0.3], p);
    check.picture(lit(scenes::phong_spot(), "", yours));
}

variants! { check:
    yours => soft_spot;
    wrong "the share has no crease" => |color, lamp, d, [inner, outer], p| {
        let light = PointLight::new(color, lamp).ok()?.illumination(p)?;
        let share = (outer - (-light.direction).angle(d)) / (outer - inner);
        let color = color * share.min(1.0);
        (share > 0.0).then_some(Illumination { color, ..light })
    };
}
