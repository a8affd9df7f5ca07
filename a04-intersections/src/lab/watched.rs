//! Counts intersection tests, by a wrapper around each geometry.

use a03_rays_cameras::Ray;
use common::tally::{self, Work};

use crate::{Geometry, Hit, Interval, World};

/// A geometry that counts the rays tested against it.
#[derive(Debug)]
struct Watched(Box<dyn Geometry>);

/// Wraps this geometry to count intersection tests.
pub fn geometry(geometry: Box<dyn Geometry>) -> Box<dyn Geometry> {
    Box::new(Watched(geometry))
}

impl Geometry for Watched {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        tally::count(Work::IntersectionTest);
        self.0.hit(ray, within)
    }
}

/// The world with its geometries and surfaces replaced by these functions of them.
pub fn world<S, T>(
    world: World<S>,
    geometry: impl Fn(Box<dyn Geometry>) -> Box<dyn Geometry>,
    surface: impl Fn(S) -> T,
) -> World<T> {
    let objects = world.objects.into_iter();
    World {
        background: world.background,
        objects: objects.map(|(g, s)| (geometry(g), surface(s))).collect(),
    }
}
