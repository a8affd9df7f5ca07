//! `Primitive`: a shape with its formulas, in lanes.
//!
//! A formula stands once: four rays meet one shape, which is then there four times, and one ray,
//! four times, meets four shapes.

use glam::DVec3;

use super::{Bounds, Rays};
use crate::lanes::{Lanes, PacketHit, Simd};

/// A bit for each of four hits that counts.
pub(crate) type Counts<'a, S> = &'a dyn Fn(&PacketHit<S>) -> u32;

/// A shape that rays are tested against.
pub(crate) trait Primitive: Copy {
    /// Four shapes side by side.
    type Four<S: Simd>;

    /// The support function: the greatest dot product of a vector with a point of the shape.
    fn support(self, _: DVec3) -> f64 {
        f64::INFINITY
    }

    /// Largest distance of a hit from the points of its ray inside of the bounds, in lengths of the
    /// direction.
    fn depth_error(self) -> f64 {
        0.0
    }

    /// Bounds that hold every hit, or all of space.
    fn bounds(self) -> Bounds {
        Bounds::from_support(|axis, sign| self.support(DVec3::AXES[axis] * sign))
    }

    /// Four shapes side by side.
    fn four<S: Simd>(simd: S, shapes: [Self; 4]) -> Self::Four<S>;

    /// The least `t` above 0 at which the ray of each lane meets the shape of the lane, with the
    /// operations of the lesson; NaN without a hit. Lanes whose bits are not set in `active` hold
    /// anything.
    fn intersect<S: Simd>(shapes: &Self::Four<S>, rays: &Rays<S>, active: u32) -> Lanes<S>;

    /// Like [`Primitive::intersect`], but a hit behind `t_max` may be left out. Shapes that take long
    /// to find their hits use it.
    #[inline(always)]
    fn intersect_before<S: Simd>(
        shapes: &Self::Four<S>,
        rays: &Rays<S>,
        active: u32,
        _t_max: Lanes<S>,
    ) -> Lanes<S> {
        Self::intersect(shapes, rays, active)
    }

    /// The hits of four rays at these `t`, which `intersect` has found in the active lanes.
    fn hits<S: Simd>(self, rays: &Rays<S>, t: Lanes<S>, active: u32) -> PacketHit<S>;

    /// A bit for each active ray whose nearest hit of any part of the shape, at a `t` below
    /// `before`, counts. Called where the nearest hit of the shape does not count, so that none of
    /// a single part does.
    fn any_hit_of_parts<S: Simd>(
        self,
        _: &Rays<S>,
        _before: Lanes<S>,
        _active: u32,
        _: Counts<S>,
    ) -> u32 {
        0
    }
}

/// [`Primitive::hits`] of a shape, compiled once for each kind: shapes of a scene and shapes under
/// transforms share it.
#[inline(never)]
pub(crate) fn hits<S: Simd, P: Primitive>(
    shape: P,
    rays: &Rays<S>,
    t: Lanes<S>,
    active: u32,
) -> PacketHit<S> {
    t.simd.vectorize(
        #[inline(always)]
        || shape.hits(rays, t, active),
    )
}
