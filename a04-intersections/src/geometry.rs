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
    /// to it. This holds at the origin of the ray, too, where `t` is 0: a ray that
    /// starts on the shape hits it there if the interval contains 0. As
    /// [`Interval::AHEAD`] does not, a ray that touches a shape at its own origin
    /// and nowhere else misses it.
    ///
    /// A ray within a flat shape, such as a plane, a disc or a triangle, has no
    /// single `t`, and misses it; where rounding moves the ray off the plane, it may
    /// hit. A box is solid, also where it is flat: a ray within a face hits the box
    /// where it enters or leaves the face.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit>;

    /// Whether any hit within the interval counts. For a convex shape it is enough to
    /// ask for the nearest one. A geometry of several parts asks each of them, because a hit
    /// that does not count must not hide the hits of the other parts.
    fn any_hit(&self, ray: &Ray, within: Interval, counts: &dyn Fn(&Hit) -> bool) -> bool {
        self.hit(ray, within).is_some_and(|hit| counts(&hit))
    }
}

impl<G: Geometry + ?Sized> Geometry for Box<G> {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        (**self).hit(ray, within)
    }

    fn any_hit(&self, ray: &Ray, within: Interval, counts: &dyn Fn(&Hit) -> bool) -> bool {
        (**self).any_hit(ray, within, counts)
    }
}
