//! A lamp that is weaker the farther away it is.

use crate::prelude::*;

/// The light that arrives at a point from a lamp, whose colour is that at the distance 1.
/// None in the lamp itself.
///
/// A vector has `v.dot(v)`, `v.magnitude()` and `v.normalized()`, which is `None` for the zero vector.
pub fn fading_light(color: Color, lamp: Point3, point: Point3) -> Option<Illumination> {
    missing!("colour, direction and distance of the light", None, {
        let way = lamp - point;
        Some(Illumination {
            // The same light falls on a sphere of the area 4 π d².
            color: color * (1.0 / way.dot(way)),
            direction: way.normalized()?,
            distance: way.magnitude(),
        })
    })
}

testing::examples! {
    let from = |y| fading_light(Color::RED, Point3::new(0.0, 4.0, 0.0), Point3::new(0.0, y, 0.0));
    let light = from(2.0).unwrap();
    assert_close!(light.color, Color::RED * 0.25, "at the distance 2");
    assert_close!(array(light.direction), [0.0, 1.0, 0.0], "to the lamp");
    assert_close!(light.distance, 2.0);
    assert!(from(4.0).is_none(), "no light in the lamp");
}
