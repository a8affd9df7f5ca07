//! `ray_to_object` with the origin moved as a vector from the origin of the space.

use crate::prelude::*;

pub fn ray_to_object(transform: &Transform, ray: &Ray) -> Ray {
    let zero = transform.inverse() * Point3::ORIGIN;
    let origin = zero + transform.inverse() * (ray.origin() - Point3::ORIGIN);
    Ray::derived(origin, transform.inverse() * ray.direction())
}

pub fn normal_from_object(transform: &Transform, n: Normal3) -> Option<Normal3> {
    let normal = transform.inverse().transposed() * Vector3::from(n);
    Some(normal.unit("normal").ok()?.as_normal())
}
