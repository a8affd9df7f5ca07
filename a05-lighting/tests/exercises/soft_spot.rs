//! Parts of the way from the inner to the outer angle, and what
//! `x² (3 - 2 x)` makes of them.

use a02_math::{Point3, Vector3};
use a05_lighting::{Lambert, Light};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::Check;

use crate::scene::{balls, show};

pub fn check<L: Light + 'static>(
    check: &mut Check,
    new: impl Fn(Color, Point3, Vector3, f64, f64) -> Result<L, ArgumentError>,
) {
    let at = Point3::new(1.0, 5.0, -2.0);
    let (inner, outer) = (0.4, 1.2);
    for length in [1.0, 3.0] {
        let down = Vector3::new(0.0, -length, 0.0);
        let Ok(spot) = new(Color::WHITE, at, down, inner, outer) else {
            return;
        };
        for (angle, exact) in [
            (0.0, Some(1.0)),
            (0.39, Some(1.0)),
            // x is 3/4, 1/2 and 1/4.
            (0.6, Some(0.843_75)),
            (0.8, Some(0.5)),
            (1.0, Some(0.156_25)),
            (1.21, None),
            // Above the lamp.
            (2.5, None),
            (3.1, None),
        ] {
            for (x, z) in [(1.0, 0.0), (0.6, -0.8), (-0.28, 0.96)] {
                let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                let point = at + Vector3::new(sin * x, -cos, sin * z) * 3.0;
                let got = spot.illumination(point).map(|light| light.color.r);
                let what = format!("the share at {angle} radians, direction of length {length}");
                check.expect(what, exact, Bound::Absolute(1e-13), got);
            }
        }
    }

    let position = Point3::new(0.5, 5.0, 2.5);
    let aim = Point3::new(-0.2, 0.0, 0.2) - position;
    let spot = new(Color::WHITE, position, aim, 0.2, 0.45);
    let world = spot.and_then(|spot| Ok(balls(Lambert::new)?.lit_by(Box::new(spot))));
    show(check, world);
}
