//! `ShapeRow` and `Shapes`: what is written once over the rows of all shapes: reading and writing
//! scene files, and the translation for the engine.

use std::any::Any;

use a03_rays_cameras::Ray;
use scene_file::{Error, Item, Key, OwnTable, SceneFile, WrittenShape};

use crate::{Geometry, Hit, Interval, World};

/// The values of a table, by their keys.
pub type Values = Vec<(&'static str, Vec<f64>)>;

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
    /// Reads it from its table. `shapes` are those that a group may have.
    fn read(item: &Item, shapes: Shapes) -> Result<Self, Error>
    where
        Self: Sized;

    /// The values that [`ShapeKind::read`] reads, or its children.
    fn content(&self) -> Content<'_>;

    /// The engine's own shape; if there is none, the engine asks `hit`, ray by ray.
    fn for_engine(&self) -> Option<engine::Shape<'static>> {
        None
    }

    /// The children that are reported one by one when a ray is explained.
    fn children_mut(&mut self) -> Option<&mut Vec<Box<dyn Geometry>>> {
        None
    }

    /// The intersection tests that a ray takes, without those of the children above.
    fn tests(&self) -> u64 {
        1
    }

    /// Reports the ray in the space of its children, if it transforms rays.
    fn push_object_ray(&self, _ray: &Ray) {}
}

/// Reads a shape of any type.
type Read = fn(&Item, Shapes) -> Result<Box<dyn Geometry>, Error>;

/// A type of shapes.
#[derive(Debug)]
pub struct ShapeRow {
    /// The name of its table in a scene file.
    pub key: &'static str,
    /// The section of the book that explains it.
    pub section: &'static str,
    /// The keys of its table; none if the list of the book, `keys.md`, has them.
    keys: &'static [Key],
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
            keys: &[],
            read: |item, shapes| Ok(Box::new(K::read(item, shapes)?)),
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

    /// The same row of a table that the list of the book lacks, with its keys.
    #[must_use]
    pub const fn with_keys(mut self, keys: &'static [Key]) -> Self {
        self.keys = keys;
        self
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
#[derive(Clone, Copy)]
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

    /// The tables of these shapes that the list of the book lacks.
    #[must_use]
    pub fn own_tables(self) -> Vec<OwnTable> {
        let own = self.rows().filter(|row| !row.keys.is_empty());
        let table = |row: &ShapeRow| OwnTable {
            name: row.key,
            keys: row.keys,
        };
        own.map(table).collect()
    }

    /// Reads a shape from its table.
    pub fn read(self, item: &Item) -> Result<Box<dyn Geometry>, Error> {
        let name = item.kind.name;
        match self.rows().find(|row| row.key == name) {
            Some(row) => (row.read)(item, self),
            None => Err(item.error("", format!("no row of this stage reads a {name}"))),
        }
    }

    /// Adds the shapes of a file to a world, with their surfaces.
    pub fn read_objects<S>(
        self,
        world: &mut World<S>,
        file: &SceneFile,
        surface: impl Fn(&Item) -> Result<S, Error>,
    ) -> Result<(), Error> {
        for item in &file.shapes {
            world.objects.push((self.read(item)?, surface(item)?));
        }
        Ok(())
    }

    /// Adds the objects of a world to a scene of the engine, in their order.
    pub fn add_objects<'a, S>(
        self,
        scene: &mut engine::Scene<'a>,
        world: &'a World<S>,
        surface: impl Fn(&'a S) -> engine::Surface<'a>,
    ) {
        for (geometry, own) in world.objects() {
            let index = scene.add_surface(surface(own));
            self.add_shapes(geometry, &mut |shape| scene.add_shape(shape, index));
        }
    }

    /// Adds the engine's shapes for a geometry: of its children, unless rounding in their
    /// transform may destroy their normals; numbers if the engine has its type; otherwise a
    /// function.
    pub fn add_shapes<'a>(
        self,
        geometry: &'a dyn Geometry,
        add: &mut dyn FnMut(engine::Shape<'a>),
    ) {
        let kind = self.row(geometry).and_then(|row| row.get(geometry));
        if let Some(shape) = kind.and_then(ShapeKind::for_engine) {
            add(shape);
        } else if let Some(Content::Children { shapes, transform }) = kind.map(ShapeKind::content)
            && transform
                .as_ref()
                .is_none_or(|transform| transform.is_well_conditioned())
        {
            for child in shapes {
                self.add_shapes(child, &mut |shape| match &transform {
                    Some(transform) => add(shape.transformed(transform)),
                    None => add(shape),
                });
            }
        } else {
            add(engine::Shape::compound(
                |ray| {
                    let hit = geometry.hit(&Ray::from(ray), Interval::AHEAD);
                    hit.map(Into::into)
                },
                |ray, before, counts| {
                    let counts = |hit: &Hit| counts(&engine::Hit::from(*hit));
                    geometry.any_hit(&Ray::from(ray), Interval::before(before), &counts)
                },
            ));
        }
    }

    /// The shapes of a world as the values of their tables, each with the number of its surface,
    /// from 0.
    #[must_use]
    pub fn written<S>(self, world: &World<S>) -> Vec<WrittenShape> {
        let mut written = Vec::new();
        for (surface, (geometry, _)) in (0..).zip(world.objects()) {
            self.write(geometry, &[], surface, &mut written);
        }
        written
    }

    fn write(
        self,
        geometry: &dyn Geometry,
        transforms: &[engine::Transform],
        surface: usize,
        written: &mut Vec<WrittenShape>,
    ) {
        let row = self.row(geometry);
        let mut shape = WrittenShape {
            key: row.map(|row| row.key),
            own_keys: row.map_or(&[], |row| row.keys),
            values: Vec::new(),
            transforms: transforms.to_vec(),
            surface,
        };
        match row
            .and_then(|row| row.get(geometry))
            .map(ShapeKind::content)
        {
            Some(Content::Children { shapes, transform }) => {
                shape
                    .transforms
                    .extend(transform.map(|transform| *transform));
                for child in shapes {
                    self.write(child, &shape.transforms, surface, written);
                }
            }
            Some(Content::Values(values)) => {
                shape.values = values;
                written.push(shape);
            }
            None => written.push(shape),
        }
    }
}
