//! Asks materials for the colours of surfaces that an eye sees.

use std::sync::Arc;

use crate::prelude::*;

/// The colour of a surface of some parameters, by the ray, its hit, and the light there.
pub type Shading<P> = Arc<dyn Fn(P, &Ray, &Hit, &dyn Lighting) -> Color + Send + Sync>;

/// The code that shades surfaces by this function.
pub fn shading<P>(
    color: impl Fn(P, &Ray, &Hit, &dyn Lighting) -> Color + Send + Sync + 'static,
) -> Shading<P> {
    Arc::new(color)
}

/// An exercise whose file asks materials of some parameters, and surfaces that an eye sees.
pub fn materials<P: Input + Default + 'static>() -> Exercise<Shading<P>> {
    Exercise::asked(|shading: &Shading<P>, (parameters, seen): (P, Seen)| {
        shading(parameters, &seen.ray(), &seen.hit(), &seen.light()).channels()
    })
}

/// The ambient light that a surface reflects, and the part that it reflects of each light.
pub fn sum(
    diffuse: Color,
    ray: &Ray,
    hit: &Hit,
    lighting: &dyn Lighting,
    reflected: impl Fn(&Illumination) -> Color,
) -> Color {
    let mut sum = diffuse * lighting.ambient();
    lighting.for_each_light(ray, hit, &mut |light| sum += reflected(light));
    sum
}
