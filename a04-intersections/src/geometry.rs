//! `Geometry`: a shape that rays can hit.

use std::any::Any;
use std::fmt::Debug;

use a03_rays_cameras::Ray;

use crate::{Hit, Interval};

/// A shape that rays can hit.
pub trait Geometry: Any + Debug + Send + Sync {
    /// The nearest hit whose `t` lies within the interval, with the normal that
    /// points out of the shape. The direction of the ray may have any length,
    /// which is the unit of `t`.
    ///
    /// A ray that touches the shape hits it: borders, edges and corners belong
    /// to it.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit>;
}

impl<G: Geometry + ?Sized> Geometry for Box<G> {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        (**self).hit(ray, within)
    }
}
