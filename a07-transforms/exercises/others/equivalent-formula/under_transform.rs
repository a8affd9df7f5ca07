//! `normal_from_object` by dot products with the columns of the inverse.

use crate::prelude::*;

pub fn ray_to_object(transform: &Transform, ray: &Ray) -> Ray {
    let back = transform.inverse();
    Ray::derived(back * ray.origin(), back * ray.direction())
}

pub fn normal_from_object(transform: &Transform, n: Normal3) -> Option<Normal3> {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let along = axes.map(|axis| n.dot(transform.inverse() * vector(axis)));
    vector(along).normalized().map(Vector3::as_normal)
}
