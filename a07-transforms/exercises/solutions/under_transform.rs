//! The ray and the normal under a transform: the lesson's own.

use crate::prelude::*;

pub fn ray_to_object(transform: &Transform, ray: &Ray) -> Ray {
    transform.ray_to_object(ray)
}

pub fn normal_from_object(transform: &Transform, n: Normal3) -> Option<Normal3> {
    transform.normal_from_object(n)
}
