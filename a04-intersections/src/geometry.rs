//! `Geometry`: a shape that rays can meet.

use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

use a03_rays_cameras::Ray;

use crate::{Bounds, Hit, Interval};

/// A shape that rays can meet.
///
/// [`Geometry::hit`] is all that a shape must answer. The rest helps to leave
/// out shapes that a ray can't meet.
pub trait Geometry: Any + Debug + Send + Sync {
    /// The nearest meeting whose `t` lies within the interval, with the normal
    /// that points out of the shape. The direction of the ray may have any
    /// length, and `t` counts in that length.
    ///
    /// What touches the shape meets it: borders, edges and corners belong to it.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit>;

    /// Bounds that hold the shape.
    fn bounds(&self) -> Bounds {
        Bounds::EVERYWHERE
    }

    /// Geometries that together are hit as this one is, and that are worth being
    /// asked one by one; of several hit at the same place the first counts.
    /// None if there is nothing to take apart.
    fn parts(&self) -> Option<Vec<Arc<dyn Geometry>>> {
        None
    }
}

impl<G: Geometry + ?Sized> Geometry for Box<G> {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        (**self).hit(ray, within)
    }

    fn bounds(&self) -> Bounds {
        (**self).bounds()
    }

    fn parts(&self) -> Option<Vec<Arc<dyn Geometry>>> {
        (**self).parts()
    }
}
