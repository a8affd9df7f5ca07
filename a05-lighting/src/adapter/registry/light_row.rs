//! `LightRow` and `Lights`: what is written once over the rows of all lights.

use std::any::Any;

use a02_math::Point3;
use scene_export::{Values, WrittenLight};
use scene_file::{Error, Item};

use crate::Light;

/// What the engine and scene files need to know of a type of lights.
pub trait LightKind: Light {
    /// Reads it from its table.
    fn read(item: &Item) -> Result<Self, Error>
    where
        Self: Sized;

    /// The values that [`LightKind::read`] reads.
    fn content(&self) -> Values;

    /// The engine's own light; if there is none, the engine asks `illumination`, point by point.
    fn for_engine(&self) -> Option<engine::Emitter<'static>> {
        None
    }
}

/// Reads a light of any type.
type Read = fn(&Item) -> Result<Box<dyn Light>, Error>;

/// A type of lights.
pub struct LightRow {
    /// The name of its table in a scene file.
    pub key: &'static str,
    read: Read,
    get: fn(&dyn Light) -> Option<&dyn LightKind>,
}

impl LightRow {
    /// The row of a type with this table.
    #[must_use]
    pub const fn of<K: LightKind>(key: &'static str) -> Self {
        Self {
            key,
            read: |item| Ok(Box::new(K::read(item)?)),
            get: |light| {
                let any: &dyn Any = light;
                any.downcast_ref::<K>().map(|light| light as _)
            },
        }
    }
}

/// The rows of all lights.
#[derive(Clone, Copy)]
pub struct Lights(pub &'static [LightRow]);

impl Lights {
    /// Reads a light from its table.
    pub fn read(self, item: &Item) -> Result<Box<dyn Light>, Error> {
        let name = item.kind.name;
        match self.0.iter().find(|row| row.key == name) {
            Some(row) => (row.read)(item),
            None => Err(item.error("", format!("no row of this stage reads a {name}"))),
        }
    }

    /// A light as the values of its table.
    #[must_use]
    pub fn written(self, light: &dyn Light) -> WrittenLight {
        let known = |row: &LightRow| Some((row.key, (row.get)(light)?.content()));
        let (key, values) = self.0.iter().find_map(known).unzip();
        WrittenLight {
            key,
            values: values.unwrap_or_default(),
        }
    }

    /// The engine's light: numbers if the engine has its type, otherwise a function.
    #[must_use]
    pub fn for_engine(self, light: &dyn Light) -> engine::Emitter<'_> {
        let known = self.0.iter().find_map(|row| (row.get)(light));
        if let Some(light) = known.and_then(LightKind::for_engine) {
            return light;
        }
        engine::Emitter::Other(Box::new(|point| {
            let light = light.illumination(Point3::from_glam(point))?;
            Some(engine::Illumination {
                color: light.color,
                direction: light.direction.to_glam(),
                distance: light.distance,
            })
        }))
    }
}
