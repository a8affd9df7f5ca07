//! A light that shines from one point in all directions.

use crate::prelude::*;

/// The light of a lamp that arrives at a point: its colour, the direction of length 1 from
/// the point to the lamp, and the distance. None in the lamp itself.
///
/// `vector.magnitude()` is a length; `vector.normalized()` is `None` for the zero vector.
pub fn point_light(color: Color, lamp: Point3, point: Point3) -> Option<Illumination> {
    // 1. Take the displacement from the point to the lamp.
    // 2. Normalise it for the direction; none if it has no length.
    // 3. Return colour, direction and distance.
    missing!("the light that arrives", None, {
        let to_lamp = lamp - point;
        let direction = to_lamp.normalized()?;
        let distance = to_lamp.magnitude();
        Some(Illumination {
            color,
            direction,
            distance,
        })
    })
}

testing::examples! {
    let from = |y| {
        let light = point_light(Color::RED, Point3::new(0.0, 4.0, 0.0), Point3::new(0.0, y, 0.0))?;
        Some((light.color, light.direction.y(), light.distance))
    };
    assert_close!(from(0.0), Some((Color::RED, 1.0, 4.0)), "below it");
    assert_close!(from(6.0), Some((Color::RED, -1.0, 2.0)), "above it");
    assert!(from(4.0).is_none(), "no light in the lamp");
}
