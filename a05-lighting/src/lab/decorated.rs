//! `decorated`: a world whose objects have wrappers around them.

use a04_intersections::Geometry;
use common::ArgumentError;

use crate::LitWorld;

/// The world with the same lights, and with its geometries and surfaces replaced
/// by these functions of them.
pub fn decorated<S, T, L>(
    world: LitWorld<S, L>,
    geometry: impl Fn(Box<dyn Geometry>) -> Box<dyn Geometry>,
    surface: impl Fn(S) -> T,
) -> Result<LitWorld<T, L>, ArgumentError> {
    let (world, lights, ambient) = world.into_parts();
    let mut decorated = LitWorld::empty(world.background(), ambient)?;
    for (g, s) in world.into_objects() {
        decorated = decorated.with(geometry(g), surface(s));
    }
    Ok(lights.into_iter().fold(decorated, LitWorld::lit_by))
}
