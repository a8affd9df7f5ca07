//! Reports light and colours, by wrappers around lights and materials.

mod material;

use a02_math::Point3;
use a02_math::arrays::array;
use a04_intersections::Geometry;
use a04_intersections::instruments::instrumented as geometries;
use a04_intersections::registry::Shapes;
use common::steps::{self, Step, StepKind, type_name};

use crate::{Illumination, Light, LitWorld};

pub use material::{InstrumentedMaterial, material, shaded};

/// The world with its geometries wrapped, which may be of these shapes, and its surfaces and
/// lights replaced by these functions of them; lights are counted from 1.
pub fn world<S, T, L>(
    world: LitWorld<S, L>,
    shapes: Shapes,
    surface: impl Fn(S) -> T,
    light: impl Fn((usize, L)) -> L,
) -> LitWorld<T, L> {
    let geometry = |number, geometry| geometries::geometry(number, geometry, shapes);
    map_world(world, geometry, surface, light)
}

/// The world with its surfaces replaced by this function of them.
pub fn map_surfaces<S, T, L>(world: LitWorld<S, L>, surface: impl Fn(S) -> T) -> LitWorld<T, L> {
    map_world(world, |_, geometry| geometry, surface, |(_, light)| light)
}

/// The world with its geometries, surfaces and lights replaced by these functions of them;
/// geometries and lights are counted from 1.
pub fn map_world<S, T, L>(
    world: LitWorld<S, L>,
    geometry: impl Fn(usize, Box<dyn Geometry>) -> Box<dyn Geometry>,
    surface: impl Fn(S) -> T,
    light: impl Fn((usize, L)) -> L,
) -> LitWorld<T, L> {
    LitWorld {
        world: geometries::map_world(world.world, geometry, surface),
        lights: (1..).zip(world.lights).map(light).collect(),
        ambient: world.ambient,
    }
}

/// A light that is reported.
#[derive(Debug)]
struct InstrumentedLight {
    light: Box<dyn Light>,
    number: usize,
    type_name: String,
}

/// Wraps a light, counted from 1, to report what arrives from it.
pub fn light((number, light): (usize, Box<dyn Light>)) -> Box<dyn Light> {
    Box::new(InstrumentedLight {
        type_name: type_name(&light),
        number,
        light,
    })
}

impl Light for InstrumentedLight {
    fn illumination(&self, point: Point3) -> Option<Illumination> {
        let light = self.light.illumination(point);
        push_light(self.number, &self.type_name, light);
        light
    }
}

/// Reports the light that arrives from a source, counted from 1, of this type.
pub fn push_light(number: usize, type_name: &str, light: Option<Illumination>) {
    steps::heading(StepKind::Light, |kind| {
        let name = format!("light {number}: {type_name}");
        let step = Step::new(kind, name, "a05-lighting.md#three-lights")
            .about(type_name)
            .numbered(number);
        match light {
            Some(light) => step
                .with("cl", light.color.channels())
                .with("l", array(light.direction))
                .with("distance", [light.distance]),
            None => step,
        }
    });
}
