//! `Sheared`: a shape that leans.

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};

/// A shape whose points have been pushed aside by their height: (x, y, z) has
/// become (x + `by` y, y, z).
#[derive(Clone, Copy, Debug)]
pub struct Sheared<G> {
    shape: G,
    by: f64,
}

impl<G> Sheared<G> {
    /// This shape, sheared.
    pub const fn new(shape: G, by: f64) -> Self {
        Self { shape, by }
    }

    /// The ray as the upright shape sees it, with the same `t`.
    fn ray_to_shape(&self, ray: &Ray) -> Ray {
        let (o, d) = (ray.origin(), ray.direction());
        // Points and vectors alike: a shear leaves the origin where it is.
        let o = Point3::new(o.x() - self.by * o.y(), o.y(), o.z());
        let d = Vector3::new(d.x() - self.by * d.y(), d.y(), d.z());
        Ray::derived(o, d)
    }

    /// A normal of the upright shape as the leaning one has it.
    fn normal_from_shape(&self, n: Normal3) -> Option<Normal3> {
        // The transpose of the inverse matrix.
        let n = Vector3::new(n.x(), n.y() - self.by * n.x(), n.z());
        n.normalized().map(Vector3::as_normal)
    }
}

impl<G: Geometry> Geometry for Sheared<G> {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let Hit { t, normal, face } = self.shape.hit(&self.ray_to_shape(ray), within)?;
        Some(Hit {
            t,
            normal: self.normal_from_shape(normal)?,
            face: self.normal_from_shape(face)?,
        })
    }
}
