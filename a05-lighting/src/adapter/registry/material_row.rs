//! `MaterialRow` and `Materials`: what is written once over the rows of all materials.

use std::any::Any;

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::Color;
use scene_export::Values;
use scene_file::{Error, Item, SceneFile};

use crate::{Lighting, Material, Phong};

/// What the engine, scene files and the explanation need to know of a type of materials.
pub trait MaterialKind: Material {
    /// Reads it from its table.
    fn read(item: &Item) -> Result<Self, Error>
    where
        Self: Sized;

    /// The values that [`MaterialKind::read`] reads.
    fn content(&self) -> Values;

    /// The engine's own material; if there is none, the engine asks `color_for`, hit by hit.
    fn for_engine(&self) -> Option<engine::Shading<'static>> {
        None
    }

    /// The Phong material in it, whose highlight takes a power.
    fn as_phong(&self) -> Option<&Phong> {
        None
    }
}

/// Reads a material of any type.
type Read = fn(&Item) -> Result<Box<dyn Material>, Error>;

/// A type of materials.
#[derive(Debug)]
pub struct MaterialRow {
    /// The key by which a table chooses this type; empty if no key does.
    pub key: &'static str,
    /// The section of the book that explains it.
    pub section: &'static str,
    read: Read,
    get: fn(&dyn Material) -> Option<&dyn MaterialKind>,
}

impl MaterialRow {
    /// The row of a type that this key chooses, and this section of the book explains.
    #[must_use]
    pub const fn of<K: MaterialKind>(key: &'static str, section: &'static str) -> Self {
        Self {
            key,
            section,
            read: |item| Ok(Box::new(K::read(item)?)),
            get: |material| {
                let any: &dyn Any = material;
                any.downcast_ref::<K>().map(|material| material as _)
            },
        }
    }
}

/// The material in a box, for stages whose surfaces are another trait.
impl Material for Box<dyn Material> {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        (**self).color_for(ray, hit, lighting)
    }
}

/// A material without the boxes around it.
fn unboxed(material: &dyn Material) -> &dyn Material {
    let any: &dyn Any = material;
    match any.downcast_ref::<Box<dyn Material>>() {
        Some(inner) => unboxed(&**inner),
        None => material,
    }
}

/// The rows of a stage: its own, and those of the stages below.
#[derive(Clone, Copy, Debug)]
pub struct Materials(pub &'static [&'static [MaterialRow]]);

impl Materials {
    /// All rows.
    pub fn rows(self) -> impl Iterator<Item = &'static MaterialRow> {
        self.0.iter().copied().flatten()
    }

    /// Reads the material of a shape of this file: its colour, or the material that it names.
    pub fn read_of(self, shape: &Item, file: &SceneFile) -> Result<Box<dyn Material>, Error> {
        if shape.find("color").is_some() {
            return self.read(shape);
        }
        self.read(shape.named("material", &file.materials)?)
    }

    /// Reads a material from its table: as the type that one of its keys chooses, or else as that of the
    /// first row.
    pub fn read(self, item: &Item) -> Result<Box<dyn Material>, Error> {
        let chosen = self.rows().find(|row| item.find(row.key).is_some());
        match chosen.or_else(|| self.rows().next()) {
            Some(row) => (row.read)(item),
            None => Err(item.error("", "no row of this stage reads a material")),
        }
    }

    /// A material as the values of its table; none if its type has no row.
    #[must_use]
    pub fn written(self, material: &dyn Material) -> Option<Values> {
        Some(self.row(material)?.1.content())
    }

    /// The row of a material, and the material as one of its type.
    fn row(self, material: &dyn Material) -> Option<(&'static MaterialRow, &dyn MaterialKind)> {
        let material = unboxed(material);
        self.rows()
            .find_map(|row| Some((row, (row.get)(material)?)))
    }

    /// The section of the book that explains a material.
    #[must_use]
    pub fn section(self, material: &dyn Material) -> &'static str {
        let row = self.row(material);
        row.map_or("a05-lighting.md#two-questions", |(row, _)| row.section)
    }

    /// The Phong material in a material, if there is one.
    #[must_use]
    pub fn as_phong(self, material: &dyn Material) -> Option<&Phong> {
        self.row(material)?.1.as_phong()
    }

    /// The engine's material: numbers if the engine has its type, otherwise the function `color`.
    pub fn for_engine<'a>(
        self,
        material: &'a dyn Material,
        color: impl Fn(&Ray, &Hit) -> Color + Send + Sync + 'a,
    ) -> engine::Shading<'a> {
        let known = self.row(material);
        let shading = known.and_then(|(_, material)| material.for_engine());
        shading.unwrap_or_else(|| {
            engine::Shading::Other(Box::new(move |ray, hit| color(&ray.into(), &hit.into())))
        })
    }
}
