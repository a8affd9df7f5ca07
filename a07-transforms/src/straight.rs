//! `Straight`: a transform that turns nothing, in fewer operations.
//!
//! Moved and stretched along the axes only, each coordinate depends on itself
//! alone. What the matrix adds to it from the others is 0 times a number, and
//! adding 0 rounds nothing: so the results are those of the matrix, to the last
//! bit. (The sign of a 0 may differ, on which no formula here depends.)

use a02_math::{Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;

use crate::Transform;

/// The way from the space around an object to its own: `x' = factor x + way`,
/// axis by axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Straight {
    factors: [f64; 3],
    way: [f64; 3],
}

impl Straight {
    /// What the transform does, if it turns nothing.
    pub fn new(transform: &Transform) -> Option<Self> {
        let rows = transform.inverse().rows();
        let turns =
            (0..3).any(|row| (0..3).any(|column| row != column && rows[row][column] != 0.0));
        (!turns).then(|| Self {
            factors: std::array::from_fn(|axis| rows[axis][axis]),
            way: std::array::from_fn(|axis| rows[axis][3]),
        })
    }

    pub fn ray_to_object(&self, ray: &Ray) -> Ray {
        let (o, d, way) = (ray.origin(), ray.direction(), self.way);
        let o = self.times(o.x(), o.y(), o.z());
        let o = Point3::new(o.x() + way[0], o.y() + way[1], o.z() + way[2]);
        Ray::derived(o, self.times(d.x(), d.y(), d.z()))
    }

    pub fn normal_from_object(&self, n: Normal3) -> Option<Normal3> {
        let n = self.times(n.x(), n.y(), n.z());
        n.normalized().map(Vector3::as_normal)
    }

    fn times(&self, x: f64, y: f64, z: f64) -> Vector3 {
        let [a, b, c] = self.factors;
        Vector3::new(a * x, b * y, c * z)
    }
}
