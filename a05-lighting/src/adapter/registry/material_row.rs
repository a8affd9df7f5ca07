//! `MaterialRow` and `Materials`: what is written once over the rows of all materials.

use std::any::Any;

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use common::Color;

use crate::{Material, Phong};

/// What the engine and the explanation need to know of a type of materials.
///
/// Scene files have one table for all of them; which type it means depends on the stage.
pub trait MaterialKind: Material {
    /// Its numbers for the engine.
    fn for_engine(&self) -> engine::Shading<'static>;

    /// The Phong material in it, whose highlight takes a power.
    fn as_phong(&self) -> Option<&Phong> {
        None
    }
}

/// A type of materials.
#[derive(Debug)]
pub struct MaterialRow {
    /// The section of the book that explains it.
    pub section: &'static str,
    get: fn(&dyn Material) -> Option<&dyn MaterialKind>,
}

impl MaterialRow {
    /// The row of a type that this section of the book explains.
    #[must_use]
    pub const fn of<K: MaterialKind>(section: &'static str) -> Self {
        Self {
            section,
            get: |material| {
                let any: &dyn Any = material;
                any.downcast_ref::<K>().map(|material| material as _)
            },
        }
    }
}

/// The rows of a stage: its own, and those of the stages below.
#[derive(Clone, Copy, Debug)]
pub struct Materials(pub &'static [&'static [MaterialRow]]);

impl Materials {
    /// The row of a material, and the material as one of its type.
    fn row(self, material: &dyn Material) -> Option<(&'static MaterialRow, &dyn MaterialKind)> {
        let mut rows = self.0.iter().copied().flatten();
        rows.find_map(|row| Some((row, (row.get)(material)?)))
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

    /// The engine's material: numbers if the material's type has a row, otherwise the function
    /// `color`.
    pub fn for_engine<'a>(
        self,
        material: &'a dyn Material,
        color: impl Fn(&Ray, &Hit) -> Color + Send + Sync + 'a,
    ) -> engine::Shading<'a> {
        match self.row(material) {
            Some((_, known)) => known.for_engine(),
            None => {
                engine::Shading::Other(Box::new(move |ray, hit| color(&ray.into(), &hit.into())))
            }
        }
    }
}
