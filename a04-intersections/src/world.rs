//! `World`: all objects of a scene and its background.

use a02_math::{Direction, Vector3};
use a03_rays_cameras::Ray;
use common::{ArgumentError, Color, argument};

use crate::{Geometry, Hit, Interval};

/// A background, and a plain list of geometries, each with its surface.
///
/// The surface describes the appearance of a geometry: here a [`Color`], later a
/// material.
#[derive(Debug)]
pub struct World<S> {
    pub(crate) background: Color,
    pub(crate) objects: Vec<(Box<dyn Geometry>, S)>,
}

impl<S> World<S> {
    /// An empty world. The channels of its background are from 0
    /// to 1e50.
    pub fn new(background: Color) -> Result<Self, ArgumentError> {
        Ok(Self {
            background: argument::color("background", background)?,
            objects: Vec::new(),
        })
    }

    /// This world with one more object.
    #[must_use]
    pub fn with(mut self, geometry: impl Geometry, surface: S) -> Self {
        self.objects.push((Box::new(geometry), surface));
        self
    }

    /// The objects in the order of the list, as pairs of geometry and surface.
    pub fn objects(&self) -> impl Iterator<Item = (&dyn Geometry, &S)> {
        let objects = self.objects.iter();
        objects.map(|(geometry, surface)| (&**geometry, surface))
    }

    /// The colour of a ray that hits nothing.
    #[must_use]
    pub const fn background(&self) -> Color {
        self.background
    }

    /// The nearest hit within the interval and the surface there; if several
    /// objects have the same `t`, the first in the list.
    ///
    /// Its normals are turned to the side of the ray's origin, so that a shape
    /// is also shaded correctly from inside.
    #[must_use]
    // ANCHOR: hit
    pub fn hit(&self, ray: &Ray, mut within: Interval) -> Option<(Hit, &S)> {
        let mut nearest = None;
        for (geometry, surface) in &self.objects {
            if let Some(hit) = geometry.hit(ray, within) {
                within.max = hit.t;
                nearest = Some((hit, surface));
            }
        }
        nearest.map(|(hit, surface)| (facing(hit, ray.direction()), surface))
    }
    // ANCHOR_END: hit

    /// Whether any object is hit within the interval. The search ends at the
    /// first hit.
    #[must_use]
    pub fn is_hit(&self, ray: &Ray, within: Interval) -> bool {
        self.any_hit(ray, within, &|_| true)
    }

    /// Whether any hit within the interval counts. The search ends at the first one.
    #[must_use]
    pub fn any_hit(&self, ray: &Ray, within: Interval, counts: &dyn Fn(&Hit) -> bool) -> bool {
        let mut objects = self.objects.iter();
        objects.any(|(geometry, _)| geometry.any_hit(ray, within, counts))
    }
}

/// The hit with its normals turned against the direction `d`.
fn facing(hit: Hit, d: Vector3) -> Hit {
    if hit.geometric_normal.dot(d) > 0.0 {
        Hit {
            normal: -hit.normal,
            geometric_normal: -hit.geometric_normal,
            ..hit
        }
    } else {
        hit
    }
}

impl World<Color> {
    /// The colour that a ray brings back: the colour of the nearest object, or
    /// the background.
    #[must_use]
    pub fn color_for(&self, ray: &Ray) -> Color {
        let nearest = self.hit(ray, Interval::AHEAD);
        nearest.map_or(self.background, |(_, color)| *color)
    }
}
