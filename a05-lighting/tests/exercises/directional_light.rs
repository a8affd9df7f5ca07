//! Light that travels in directions of any length.

use a02_math::Vector3;
use a05_lighting::{Illumination, Light};
use common::{ArgumentError, Color};
use testing::exercise::{Check, Random};

use crate::lamps::{expect_light, expect_shiny, point};
use crate::lit::{INWARDS, color, frame};

pub fn check<L: Light>(
    check: &mut Check,
    new: impl Fn(Color, Vector3) -> Result<L, ArgumentError>,
) {
    let mut random = Random::new(54);
    for _ in 0..20 {
        let (color, [direction, ..]) = (color(&mut random), frame(&mut random));
        let travels = -direction * random.between(0.1, 9.0);
        let Ok(light) = new(color, travels) else {
            continue;
        };
        let words = format!(
            "at a point; light {:?} that travels along {:.3}",
            color.channels(),
            travels.to_glam()
        );
        let exact = Illumination {
            color,
            direction,
            distance: f64::INFINITY,
        };
        expect_light(
            check,
            &words,
            &light,
            point(random.triple(9.0)),
            Some(exact),
        );
    }
    expect_shiny(check, "phong-directional", || {
        Ok(Box::new(new(Color::WHITE, INWARDS)?))
    });
}
