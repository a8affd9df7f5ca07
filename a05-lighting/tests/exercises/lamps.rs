//! Helpers of the checks of lights.

use a02_math::Point3;
use a05_lighting::{Illumination, Light, Material, Phong};
use common::{ArgumentError, Color};
use measure::extremes::Bound;
use testing::exercise::Check;

use crate::lit::{expect_scene, objects};

/// Rounding errors of coordinates up to 20.
const BOUND: Bound = Bound::Absolute(1e-12);

/// Compares the light that arrives at a point with the exact one.
pub fn expect_light(
    check: &mut Check,
    words: &str,
    light: &dyn Light,
    point: Point3,
    exact: Option<Illumination>,
) {
    let got = light.illumination(point);
    let words = format!("{words}, point {:.3}", point.to_glam());
    check.expect(
        format!("whether light arrives, {words}"),
        exact.is_some(),
        Bound::Equal,
        got.is_some(),
    );
    let (Some(exact), Some(got)) = (exact, got) else {
        return;
    };
    let [direction, other] = [exact, got].map(|light| light.direction.to_glam().to_array());
    check.expect(
        format!("the direction to the light, {words}"),
        direction,
        BOUND,
        other,
    );
    check.expect(
        format!("the distance, {words}"),
        exact.distance,
        BOUND,
        got.distance,
    );
    let [color, other] = [exact, got].map(|light| light.color.channels());
    check.expect(format!("the colour, {words}"), color, BOUND, other);
}

/// Compares a scene of shiny objects under the student's light with its lock.
pub fn expect_shiny(
    check: &mut Check,
    name: &str,
    light: impl FnOnce() -> Result<Box<dyn Light>, ArgumentError>,
) {
    expect_scene(check, name, || {
        let material = |color| -> Result<Box<dyn Material>, ArgumentError> {
            Ok(Box::new(Phong::new(color, Color::WHITE, 64.0)?))
        };
        Ok(objects(material, Color::BLACK)?.lit_by(light()?))
    });
}

pub fn point(xyz: [f64; 3]) -> Point3 {
    Point3::from_glam(xyz.into())
}
