//! The lesson's points of a ray, until yours is done: `cargo learn ray`. Then copy your file here, without
//! the examples at its end.

use crate::prelude::*;

pub fn at(ray: &Ray, t: f64) -> Point3 {
    ray.at(t)
}

pub fn t_of(ray: &Ray, point: Point3) -> f64 {
    ray.t_of(point)
}
