//! A light that shines from infinitely far away, like the sun.

use crate::prelude::*;

/// The light that travels in a direction of any length, as it arrives at every point. None if
/// the direction has no length.
///
/// `vector.normalized()` is `None` for the zero vector.
pub fn directional_light(color: Color, direction: Vector3) -> Option<Illumination> {
    // 1. Find the direction to the light, of length 1; none if it has no length.
    // 2. Return it with the colour and the distance of a light beyond all objects.
    missing!("the light that arrives", None, {
        let to_light = -direction;
        let direction = to_light.normalized()?;
        let distance = f64::INFINITY;
        Some(Illumination {
            color,
            direction,
            distance,
        })
    })
}

testing::examples! {
    let light = directional_light(Color::RED, Vector3::new(0.0, -2.0, 0.0)).unwrap();
    assert_close!(light.color, Color::RED);
    assert_close!(array(light.direction), [0.0, 1.0, 0.0], "to the light, of length 1");
    assert_close!(light.distance, f64::INFINITY, "beyond all objects");
}
