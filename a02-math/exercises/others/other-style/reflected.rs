//! `reflected` by cross products, of which the second is the part along the surface.

use crate::prelude::*;

pub fn reflected(v: Vector3, n: Normal3) -> Vector3 {
    let n = Vector3::from(n);
    let along_surface = n.cross(v).cross(n);
    v - along_surface * 2.0
}
