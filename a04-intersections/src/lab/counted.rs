//! Counts intersection tests, by a wrapper around each geometry.

use a03_rays_cameras::Ray;
use common::ArgumentError;
use common::tally::{self, Work};

use crate::{Geometry, Hit, Interval, World};

/// A geometry that counts the rays tested against it.
#[derive(Debug)]
struct Counted(Box<dyn Geometry>);

/// Wraps this geometry to count intersection tests.
pub fn geometry(geometry: Box<dyn Geometry>) -> Box<dyn Geometry> {
    Box::new(Counted(geometry))
}

impl Geometry for Counted {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        tally::count(Work::IntersectionTest);
        self.0.hit(ray, within)
    }
}

/// Wraps the geometries of a world to count intersection tests.
pub fn world<S>(world: World<S>) -> Result<World<S>, ArgumentError> {
    let empty = World::new(world.background())?;
    let objects = world.into_objects().into_iter();
    Ok(objects.fold(empty, |world, (geometry, surface)| {
        world.with(Counted(geometry), surface)
    }))
}
