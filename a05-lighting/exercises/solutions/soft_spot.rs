//! A spot light whose rim fades.

use crate::prelude::*;

/// The light that arrives at a point from a lamp that shines along `direction`: full up to the
/// angle `inner` from there, and gone from the larger angle `outer` on, both in radians.
///
/// `a.angle(b)` is the angle between vectors.
pub fn soft_spot(
    color: Color,
    lamp: Point3,
    direction: Vector3,
    [inner, outer]: [f64; 2],
    point: Point3,
) -> Option<Illumination> {
    let light = PointLight::new(color, lamp).ok()?.illumination(point)?;
    let fraction = missing!("the fraction of the light that is left", 1.0, {
        // The light's direction leads to the lamp, the spot's direction away from it.
        let angle = (-light.direction).angle(direction);
        let x = ((outer - angle) / (outer - inner)).clamp(0.0, 1.0);
        x * x * (3.0 - 2.0 * x)
    });
    let color = light.color * fraction;
    (fraction > 0.0).then_some(Illumination { color, ..light })
}

testing::examples! {
    let red = |inner, outer, x, y| {
        let (down, point) = (Vector3::new(0.0, -2.0, 0.0), Point3::new(x, y, 0.0));
        let light = soft_spot(Color::RED, Point3::ORIGIN, down, [inner, outer], point);
        light.map(|light| light.color.channels()[0])
    };
    assert_close!(red(0.4, 1.2, 0.0, -3.0), Some(1.0), "in the middle");
    let eighth = std::f64::consts::FRAC_PI_8;
    // At the angle π/4, with x = 1/2 and 1/3.
    assert_close!(red(eighth, 3.0 * eighth, 1.0, -1.0), Some(0.5));
    assert_close!(red(0.0, 3.0 * eighth, -1.0, -1.0), Some(7.0 / 27.0));
    assert!(red(0.4, 1.2, 0.0, 3.0).is_none(), "no light behind the lamp");
}
