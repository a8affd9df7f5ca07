//! A shape whose hits a formula of the protocol finds.

use std::fmt;

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};

/// A formula in the place of a geometry.
pub struct Formula<F>(pub F);

impl<F> fmt::Debug for Formula<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Formula")
    }
}

impl<F: Fn(&Ray, Interval) -> Option<Hit> + Send + Sync + 'static> Geometry for Formula<F> {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        (self.0)(ray, within)
    }
}
