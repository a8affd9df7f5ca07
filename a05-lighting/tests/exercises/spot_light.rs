//! Points at known angles from the axis of a cone: narrow, wide, and more than a half
//! space.

use std::f64::consts::PI;

use a02_math::{Point3, Vector3};
use a05_lighting::{Illumination, Light};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

use crate::lamps::{expect_light, expect_shiny, point};
use crate::lit::{CORNER, INWARDS, color, frame};

pub fn check<L: Light>(
    check: &mut Check,
    new: impl Fn(Color, Point3, Vector3, f64) -> Result<L, ArgumentError>,
) {
    let mut random = Random::new(55);
    for half_angle in [0.1, 0.5, 1.0, 1.5, 1.6, 2.5, 3.0, 0.01] {
        let (color, position) = (color(&mut random), point(random.triple(5.0)));
        let [axis, side, _] = frame(&mut random);
        let cone = axis * random.between(0.1, 9.0);
        let Ok(light) = new(color, position, cone, half_angle) else {
            continue;
        };
        let mut at = |kind: &str, angle: f64, is_lit: bool| {
            let (sin, cos) = libm::sincos(angle);
            let (way, distance) = (axis * cos + side * sin, random.between(0.5, 9.0));
            let exact = is_lit.then_some(Illumination {
                color,
                direction: -way,
                distance,
            });
            let words = format!(
                "{kind}; light at {}, axis {:.3}, half angle {half_angle}, {angle:.4} from the axis",
                position.to_glam(),
                cone.to_glam()
            );
            expect_light(check, &words, &light, position + way * distance, exact);
        };
        at("on the axis", 0.0, true);
        at("in the cone", half_angle / 2.0, true);
        at("just inside the edge of the cone", half_angle - 1e-6, true);
        at(
            "just outside the edge of the cone",
            half_angle + 1e-6,
            false,
        );
        at("behind the light", PI, false);
    }
    if let Ok(light) = new(Color::WHITE, CORNER, INWARDS, PI) {
        let direction = INWARDS.normalized().unwrap_or_default();
        let exact = Illumination {
            color: Color::WHITE,
            direction,
            distance: 2.0,
        };
        let words = "behind a light that shines everywhere; half angle pi";
        expect_light(check, words, &light, CORNER + direction * -2.0, Some(exact));
    }
    expect_shiny(check, "phong-spot", || {
        Ok(Box::new(new(Color::WHITE, CORNER, INWARDS, PI / 14.0)?))
    });
}
