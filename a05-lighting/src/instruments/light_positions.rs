//! The positions of lights, so that the window can move them.

use std::any::Any;

use a02_math::Point3;

use crate::{Light, LitWorld, PointLight, SpotLight};

/// The positions of the lights that have one; `light` is the light inside of each source.
pub fn light_positions<S, L>(
    world: &mut LitWorld<S, L>,
    light: fn(&mut L) -> &mut dyn Light,
) -> Vec<&mut Point3> {
    let lights = world.lights.iter_mut();
    lights
        .filter_map(|source| position(light(source)))
        .collect()
}

fn position(light: &mut dyn Light) -> Option<&mut Point3> {
    let light: &mut dyn Any = light;
    if light.is::<PointLight>() {
        return light
            .downcast_mut()
            .map(|light: &mut PointLight| &mut light.position);
    }
    let spot: &mut SpotLight = light.downcast_mut()?;
    Some(&mut spot.source.position)
}
