//! The ray and the normal under a transform: the lesson's own.

use a02_math::Normal3;
use a03_rays_cameras::Ray;
use a07_transforms::Transform;

pub fn ray_to_object(transform: &Transform, ray: &Ray) -> Ray {
    transform.ray_to_object(ray)
}

pub fn normal_from_object(transform: &Transform, n: Normal3) -> Option<Normal3> {
    transform.normal_from_object(n)
}
