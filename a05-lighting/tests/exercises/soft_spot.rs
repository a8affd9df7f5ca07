//! Spots with narrow and wide rims, compared with the solution.

use crate::prelude::*;
use crate::solutions::soft_spot::soft_spot as solution;

pub fn check(
    check: &mut Check,
    spot: impl Fn(Color, Point3, Vector3, [f64; 2], Point3) -> Arriving + Sync,
) {
    compare_lights(
        check,
        "light {} at {}, which shines along {}, inner and outer angle {}",
        &([1.0, 0.5, 0.25], LAMP, [0.0, -2.0, 0.0], [0.5, 1.0]),
        |r| {
            let inner = r.between(0.0, 1.4);
            let angles = [inner, inner + r.between(0.05, 1.6)];
            (channels(r), r.triple(5.0), r.triple(5.0), angles)
        },
        |(c, lamp, d, angles), p| solution(color(c), point(lamp), vector(d), angles, p),
        |(c, lamp, d, angles), p| spot(color(c), point(lamp), vector(d), angles, p),
    );
    let (lamp, inwards) = (point([4.0; 3]), vector([-1.0; 3]));
    let spot = |p| spot(Color::WHITE, lamp, inwards, [0.1, 0.3], p);
    check.picture(lit(scenes::phong_spot(), spot));
}

/// A share of the angle, the inner and the outer one.
fn share(c: &mut Check, share: fn(f64, f64, f64) -> f64) {
    check(c, |color, lamp, d, [inner, outer], p| {
        let light = PointLight::new(color, lamp).ok()?.illumination(p)?;
        let share = share((-light.direction).angle(d), inner, outer);
        let color = color * share;
        (share > 0.0).then_some(Illumination { color, ..light })
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("x is never below 0, where its square grows", |c| {
        share(c, |angle, inner, outer| {
            let x = ((outer - angle) / (outer - inner)).min(1.0);
            x * x * (3.0 - 2.0 * x)
        });
    }),
    wrong("the share has no crease", |c| {
        share(c, |angle, inner, outer| {
            ((outer - angle) / (outer - inner)).clamp(0.0, 1.0)
        });
    }),
];
