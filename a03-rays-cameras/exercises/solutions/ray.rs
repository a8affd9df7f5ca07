//! `at` and `t_of`: the lesson's own.

use crate::prelude::*;

pub fn at(ray: &Ray, t: f64) -> Point3 {
    ray.at(t)
}

pub fn t_of(ray: &Ray, point: Point3) -> f64 {
    ray.t_of(point)
}
