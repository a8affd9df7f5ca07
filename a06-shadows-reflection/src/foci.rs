//! `foci`: what most rays of a picture go through.

use a03_rays_cameras::{Camera, Focus};
use a05_lighting::Light;

use crate::ShadowedWorld;

/// The focus of the camera, and those of all lights that cast shadows: no ray
/// goes to the others.
#[must_use]
pub fn foci(camera: &impl Camera, world: &ShadowedWorld) -> Vec<Focus> {
    let lights = world.lights().iter();
    let casting = lights.filter(|light| light.casts_shadows());
    let foci = camera.focus().into_iter();
    foci.chain(casting.filter_map(Light::focus)).collect()
}
