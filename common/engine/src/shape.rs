//! `Shape`: the shapes whose formulas the engine has, and a function for all others.

mod axis_aligned_box;
mod bounds;
mod disc;
mod instance;
mod list;
mod mesh;
mod plane;
mod primitive;
mod rays;
mod sheared_rays;
mod sphere;
mod transform;
mod transformed;
mod transformed_bounds;
mod triangle;

use glam::DVec3;

use crate::lanes::{Lanes, PacketHit, Simd, bits, is_set, splat};
use crate::{Hit, Ray};

pub use axis_aligned_box::AxisAlignedBox;
pub(crate) use bounds::Bounds;
pub use disc::Disc;
pub use instance::Instance;
pub(crate) use list::List;
pub(crate) use mesh::Mesh;
pub use plane::Plane;
pub(crate) use primitive::{Counts, Primitive, hits};
pub(crate) use rays::Rays;
use sheared_rays::ShearedRays;
pub use sphere::Sphere;
pub use transform::Transform;
pub(crate) use transformed::{Transformed, hits_around_identities};
pub(crate) use triangle::Corners;
pub use triangle::Triangle;

/// Finds the nearest hit of a ray, its normals pointing out of the shape.
pub type HitFn<'a> = Box<dyn Fn(&Ray) -> Option<Hit> + Send + Sync + 'a>;

/// Whether any hit of a ray at a `t` between 0 and a limit counts. It asks each part of a shape for
/// its nearest hit.
pub type AnyHitFn<'a> = Box<dyn Fn(&Ray, f64, &dyn Fn(&Hit) -> bool) -> bool + Send + Sync + 'a>;

/// A shape.
pub enum Shape<'a> {
    /// All points at one distance from a centre.
    Sphere(Sphere),
    /// Flat and endless.
    Plane(Plane),
    /// Its faces are perpendicular to the axes.
    Box(AxisAlignedBox),
    /// Three corners, each with a shading normal.
    Triangle(Triangle),
    /// The part of a plane around a point.
    Disc(Disc),
    /// A shape under one or more transforms.
    Transformed(Transformed<'a>),
    /// Shapes that stand in several places.
    Instance(Instance<'a>),
    /// A shape that the engine does not know: each ray is tested by functions.
    Other(Other<'a>),
}

/// The functions of a shape that the engine does not know.
pub struct Other<'a> {
    hit: HitFn<'a>,
    /// None for a shape of one part.
    any_hit: Option<AnyHitFn<'a>>,
}

impl<'a> Shape<'a> {
    /// A shape of one part that the engine does not know.
    pub fn other(hit: impl Fn(&Ray) -> Option<Hit> + Send + Sync + 'a) -> Self {
        Self::Other(Other {
            hit: Box::new(hit),
            any_hit: None,
        })
    }

    /// A shape that the engine does not know, and that may have several parts.
    pub fn compound(
        hit: impl Fn(&Ray) -> Option<Hit> + Send + Sync + 'a,
        any_hit: impl Fn(&Ray, f64, &dyn Fn(&Hit) -> bool) -> bool + Send + Sync + 'a,
    ) -> Self {
        Self::Other(Other {
            hit: Box::new(hit),
            any_hit: Some(Box::new(any_hit)),
        })
    }

    /// The same shape under one more transform, which has to be well conditioned. It is applied
    /// after those that the shape has.
    #[must_use]
    pub fn transformed(self, transform: &Transform) -> Self {
        let mut transformed = match self {
            Self::Transformed(shape) => shape,
            shape => Transformed {
                steps: Vec::with_capacity(1),
                shape: Box::new(shape),
            },
        };
        transformed.steps.insert(0, *transform);
        Self::Transformed(transformed)
    }
}

/// Evaluates an expression for the primitive of a shape.
macro_rules! with_primitive {
    ($shape:expr, |$primitive:ident| $body:expr) => {
        match $shape {
            Shape::Sphere($primitive) => $body,
            Shape::Plane($primitive) => $body,
            Shape::Box($primitive) => $body,
            Shape::Triangle($primitive) => {
                let $primitive = *$primitive;
                $body
            }
            Shape::Disc($primitive) => $body,
            Shape::Transformed($primitive) => $body,
            Shape::Instance($primitive) => $body,
            Shape::Other($primitive) => $body,
        }
    };
}

impl Shape<'_> {
    fn support(&self, along: DVec3) -> f64 {
        with_primitive!(self, |primitive| primitive.support(along))
    }

    fn depth_error(&self) -> f64 {
        with_primitive!(self, |primitive| primitive.depth_error())
    }

    #[inline(always)]
    fn intersect<S: Simd>(&self, rays: &Rays<S>, active: u32) -> Lanes<S> {
        with_primitive!(self, |primitive| intersect(primitive, rays, active))
    }

    fn hits<S: Simd>(&self, rays: &Rays<S>, t: Lanes<S>, active: u32) -> PacketHit<S> {
        with_primitive!(self, |primitive| hits(primitive, rays, t, active))
    }

    fn any_hit_of_parts<S: Simd>(
        &self,
        rays: &Rays<S>,
        before: Lanes<S>,
        active: u32,
        counts: Counts<S>,
    ) -> u32 {
        with_primitive!(self, |primitive| primitive
            .any_hit_of_parts(rays, before, active, counts))
    }
}

/// Where four rays meet one shape.
#[inline(always)]
fn intersect<S: Simd, P: Primitive>(shape: P, rays: &Rays<S>, active: u32) -> Lanes<S> {
    P::intersect(&P::four(rays.packet.simd(), [shape; 4]), rays, active)
}

impl Primitive for &Other<'_> {
    /// A leaf holds one of them only.
    type Four<S: Simd> = Self;

    fn four<S: Simd>(_: S, [shape, ..]: [Self; 4]) -> Self {
        shape
    }

    fn intersect<S: Simd>(shape: &Self, rays: &Rays<S>, active: u32) -> Lanes<S> {
        shape.hits(rays, splat(rays.packet.simd(), 0.0), active).t
    }

    fn hits<S: Simd>(self, rays: &Rays<S>, t: Lanes<S>, active: u32) -> PacketHit<S> {
        let rays = rays.packet.to_rays();
        let hits = [0, 1, 2, 3].map(|lane| {
            let hit = is_set(active, lane).then(|| (self.hit)(&rays[lane]));
            hit.flatten().unwrap_or(Hit::NONE)
        });
        PacketHit::new(t.simd, hits)
    }

    fn any_hit_of_parts<S: Simd>(
        self,
        rays: &Rays<S>,
        before: Lanes<S>,
        active: u32,
        counts: Counts<S>,
    ) -> u32 {
        let Some(any_hit) = &self.any_hit else {
            return 0;
        };
        let simd = before.simd;
        let rays = rays.packet.to_rays();
        let mut found = 0;
        for lane in bits(active) {
            let counts = |hit: &Hit| is_set(counts(&PacketHit::new(simd, [*hit; 4])), lane);
            if any_hit(&rays[lane], before[lane], &counts) {
                found |= 1 << lane;
            }
        }
        found
    }
}
