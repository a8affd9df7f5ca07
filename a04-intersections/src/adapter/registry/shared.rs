//! `Shared`: shapes that stand in several places of a scene, but in memory once.

use std::sync::Arc;

use a03_rays_cameras::Ray;
use scene_file::{Error, Item};

use super::{Content, ShapeKind, Shapes};
use crate::{Geometry, Hit, Interval};

/// Shapes of at most this many tests are cheaper to copy than to share.
const FEW_TESTS: u64 = 4;

/// Shapes that several nodes have as a child, each with a transform of its own: the shapes of a
/// definition, of which a clone is a use.
#[derive(Clone, Debug)]
pub struct Shared {
    shapes: Arc<[Box<dyn Geometry>]>,
    /// The intersection tests that a ray takes.
    tests: u64,
}

impl Shared {
    /// Shapes of these types.
    #[must_use]
    pub fn new(shapes: Vec<Box<dyn Geometry>>, types: Shapes) -> Self {
        let tests = shapes.iter().map(|shape| types.tests(&**shape));
        Self {
            tests: tests.sum(),
            shapes: shapes.into(),
        }
    }

    /// The shapes.
    pub fn shapes(&self) -> impl Iterator<Item = &dyn Geometry> {
        self.shapes.iter().map(|shape| &**shape)
    }

    /// A number that all uses of the same shapes have, and no others.
    #[must_use]
    pub fn id(&self) -> usize {
        self.shapes.as_ptr().addr()
    }

    /// Whether there is another use of the same shapes, and they are too many to be copied.
    #[must_use]
    pub fn is_worth_sharing(&self) -> bool {
        Arc::strong_count(&self.shapes) > 1 && self.tests > FEW_TESTS
    }
}

/// The nearest hit of its shapes.
impl Geometry for Shared {
    fn hit(&self, ray: &Ray, mut within: Interval) -> Option<Hit> {
        let mut nearest = None;
        for shape in self.shapes() {
            if let Some(hit) = shape.hit(ray, within) {
                within.max = hit.t;
                nearest = Some(hit);
            }
        }
        nearest
    }

    fn any_hit(&self, ray: &Ray, within: Interval, counts: &dyn Fn(&Hit) -> bool) -> bool {
        let mut shapes = self.shapes();
        shapes.any(|shape| shape.any_hit(ray, within, counts))
    }
}

impl ShapeKind for Shared {
    /// The children alone: a use without its definition.
    fn read(_: &Item, children: Vec<Box<dyn Geometry>>) -> Result<Self, Error> {
        Ok(Self {
            tests: children.len() as u64,
            shapes: children.into(),
        })
    }

    fn content(&self) -> Content<'_> {
        Content::Children {
            shapes: self.shapes().collect(),
            transform: None,
        }
    }

    fn as_shared(&self) -> Option<&Shared> {
        Some(self)
    }

    fn tests(&self) -> u64 {
        self.tests
    }
}
