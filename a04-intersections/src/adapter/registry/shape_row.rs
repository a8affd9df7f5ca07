//! `ShapeRow` and `Shapes`: what is written once over the rows of all shapes.

use std::any::Any;

use a03_rays_cameras::Ray;
use scene_export::Values;
use scene_file::{Error, Item};

use super::Shared;
use crate::Geometry;

/// What a shape consists of.
pub enum Content<'a> {
    /// Numbers: the values of its table in a scene file.
    Values(Values),
    /// Other shapes.
    Children {
        /// The shapes.
        shapes: Vec<&'a dyn Geometry>,
        /// From their space to the one around, if these are not the same.
        transform: Option<Box<engine::Transform>>,
    },
}

/// What the engine, scene files and the explanation need to know of a type of shapes.
pub trait ShapeKind: Geometry {
    /// Reads it from its table. `children` are the shapes of a group, which have been read.
    fn read(item: &Item, children: Vec<Box<dyn Geometry>>) -> Result<Self, Error>
    where
        Self: Sized;

    /// The values that [`ShapeKind::read`] reads, or its children.
    fn content(&self) -> Content<'_>;

    /// The engine's own shape; if there is none, the engine asks `hit`, ray by ray.
    fn for_engine(&self) -> Option<engine::Shape<'static>> {
        None
    }

    /// The children that are reported one by one when a ray is explained.
    fn children(&self) -> &[Box<dyn Geometry>] {
        &[]
    }

    /// The same children, to be wrapped.
    fn children_mut(&mut self) -> Option<&mut Vec<Box<dyn Geometry>>> {
        None
    }

    /// The intersection tests that a ray takes, without those of the children above.
    fn tests(&self) -> u64 {
        1
    }

    /// The shapes that it shares with others; none if it has its own.
    fn as_shared(&self) -> Option<&Shared> {
        None
    }

    /// Reports the ray in the space of its children, if it transforms rays.
    fn push_object_ray(&self, _ray: &Ray) {}
}

/// Reads a shape of any type.
type Read = fn(&Item, Vec<Box<dyn Geometry>>) -> Result<Box<dyn Geometry>, Error>;

/// A type of shapes.
#[derive(Debug)]
pub struct ShapeRow {
    /// The name of its table in a scene file.
    pub key: &'static str,
    /// The section of the book that explains it.
    pub section: &'static str,
    read: Read,
    get: fn(&dyn Geometry) -> Option<&dyn ShapeKind>,
    get_mut: fn(&mut dyn Geometry) -> Option<&mut dyn ShapeKind>,
}

impl ShapeRow {
    /// The row of a type, whose table `[[key]]` the list of the book, `keys.md`, has.
    #[must_use]
    pub const fn of<K: ShapeKind>(key: &'static str, section: &'static str) -> Self {
        Self {
            key,
            section,
            read: |item, children| Ok(Box::new(K::read(item, children)?)),
            get: |geometry| {
                let any: &dyn Any = geometry;
                any.downcast_ref::<K>().map(|shape| shape as _)
            },
            get_mut: |geometry| {
                let any: &mut dyn Any = geometry;
                any.downcast_mut::<K>().map(|shape| shape as _)
            },
        }
    }

    /// The shape as one of this type; none if it is of another one.
    #[must_use]
    pub fn get<'a>(&self, geometry: &'a dyn Geometry) -> Option<&'a dyn ShapeKind> {
        (self.get)(unboxed(geometry))
    }
}

/// A geometry without the boxes around it.
fn unboxed(geometry: &dyn Geometry) -> &dyn Geometry {
    let any: &dyn Any = geometry;
    match any.downcast_ref::<Box<dyn Geometry>>() {
        Some(inner) => unboxed(&**inner),
        None => geometry,
    }
}

/// The rows of a stage: its own, and those of the stages below.
#[derive(Clone, Copy, Debug)]
pub struct Shapes(pub &'static [&'static [ShapeRow]]);

impl Shapes {
    /// All rows.
    pub fn rows(self) -> impl Iterator<Item = &'static ShapeRow> {
        self.0.iter().copied().flatten()
    }

    /// The row of a geometry, if its type has one.
    #[must_use]
    pub fn row(self, geometry: &dyn Geometry) -> Option<&'static ShapeRow> {
        self.rows().find(|row| row.get(geometry).is_some())
    }

    /// The children of a geometry that are reported one by one.
    pub fn children_mut(self, geometry: &mut dyn Geometry) -> Option<&mut Vec<Box<dyn Geometry>>> {
        let row = self.row(geometry)?;
        let is_boxed = (&*geometry as &dyn Any).is::<Box<dyn Geometry>>();
        if is_boxed {
            let any: &mut dyn Any = geometry;
            let inner = any.downcast_mut::<Box<dyn Geometry>>()?;
            return self.children_mut(&mut **inner);
        }
        (row.get_mut)(geometry)?.children_mut()
    }

    /// The intersection tests that a ray takes in a geometry and its children.
    #[must_use]
    pub fn tests(self, geometry: &dyn Geometry) -> u64 {
        let Some(kind) = self.row(geometry).and_then(|row| row.get(geometry)) else {
            return 1;
        };
        let children = kind.children().iter();
        kind.tests() + children.map(|child| self.tests(&**child)).sum::<u64>()
    }

    /// Reads a shape without children from its table.
    pub fn read(self, item: &Item) -> Result<Box<dyn Geometry>, Error> {
        self.read_as(item.kind.name, item, Vec::new())
    }

    /// Reads a group of shapes, with the steps of a table.
    pub fn read_group(
        self,
        item: &Item,
        children: Vec<Box<dyn Geometry>>,
    ) -> Result<Box<dyn Geometry>, Error> {
        self.read_as("group", item, children)
    }

    fn read_as(
        self,
        name: &str,
        item: &Item,
        children: Vec<Box<dyn Geometry>>,
    ) -> Result<Box<dyn Geometry>, Error> {
        match self.rows().find(|row| row.key == name) {
            Some(row) => (row.read)(item, children),
            None => Err(item.error("", format!("no row of this stage reads a {name}"))),
        }
    }
}
