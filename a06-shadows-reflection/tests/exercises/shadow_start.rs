//! Points on triangles that stand for bulges and for hollows, compared with the solution.

use crate::prelude::*;

yours! { shadow_start }

/// The start of the shadow rays, by the corners, their normals, and the weights of the point.
type Code = fn(Corners, [Normal3; 3], [f64; 3]) -> Point3;

/// The corners of a triangle.
type Corners = [Point3; 3];

pub fn exercise() -> Exercise<Code> {
    Exercise::asked(
        |shadow_start: &Code, (corners, normals, weights): ([_; 3], [_; 3], _)| {
            let normals = normals.map(|normal| unit(normal).as_normal());
            array(shadow_start(corners.map(point), normals, weights))
        },
    )
}
