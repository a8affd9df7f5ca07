//! Triangles, also flat and far away.

use crate::prelude::*;

yours! { triangle_area }

pub fn exercise() -> Exercise<fn(Point3, Point3, Point3) -> f64> {
    Exercise::asked(|triangle_area, (a, b, c)| triangle_area(point(a), point(b), point(c)))
}
