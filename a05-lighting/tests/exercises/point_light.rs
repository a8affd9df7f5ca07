//! Points at known directions and distances from a lamp.

use a02_math::Point3;
use a05_lighting::{Illumination, Light};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

use crate::lamps::{expect_light, expect_shiny, point};
use crate::lit::{CORNER, color, frame};

pub fn check<L: Light>(check: &mut Check, new: impl Fn(Color, Point3) -> Result<L, ArgumentError>) {
    let mut random = Random::new(53);
    for _ in 0..20 {
        let (color, position) = (color(&mut random), point(random.triple(5.0)));
        let Ok(light) = new(color, position) else {
            continue;
        };
        let words = format!("; light {:?} at {}", color.channels(), position.to_glam());
        let ([direction, ..], distance) = (frame(&mut random), random.between(0.1, 9.0));
        let exact = Illumination {
            color,
            direction,
            distance,
        };
        let at = position + direction * -distance;
        expect_light(
            check,
            &format!("at a point{words}"),
            &light,
            at,
            Some(exact),
        );
        expect_light(
            check,
            &format!("in the light itself{words}"),
            &light,
            position,
            None,
        );
    }
    expect_shiny(check, "phong", || Ok(Box::new(new(Color::WHITE, CORNER)?)));
}
