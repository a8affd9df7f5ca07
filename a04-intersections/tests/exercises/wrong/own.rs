//! `Own`: a shape of a function, for wrong solutions.

use std::fmt;

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};

/// A shape whose hits a function finds.
pub struct Own<F>(pub F);

impl<F> fmt::Debug for Own<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Own")
    }
}

impl<F: Fn(&Ray, Interval) -> Option<Hit> + Send + Sync + 'static> Geometry for Own<F> {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0(ray, within)
    }
}
