//! Counts shadow rays, reflected rays and powers, by wrappers around the objects of a world.

use std::any::Any;
use std::cell::Cell;

use a03_rays_cameras::{Ray, TracedWorld};
use a04_intersections::{Geometry, Hit, Interval, watched as geometries};
use a05_lighting::watched::{self as materials, Watched};
use a05_lighting::{Lighting, Material, Phong};
use common::Color;
use common::tally::{self, Work};

use crate::lab::all_work::NaiveTracer;
use crate::{RecursiveTracer, Reflective, ShadowedWorld, Surface};

thread_local! {
    /// The ray for which the world is searched next; none for a ray from the camera.
    static NEXT: Cell<Option<Work>> = const { Cell::new(None) };
}

/// A world whose work is counted.
pub struct WatchedWorld {
    world: ShadowedWorld,
    all_work: bool,
}

impl WatchedWorld {
    /// Wraps the objects of a world. Every search of the world tests its first geometry, which
    /// counts the searches.
    pub fn new(
        world: ShadowedWorld,
        watched: fn(Box<dyn Geometry>) -> Box<dyn Geometry>,
        all_work: bool,
    ) -> Self {
        let is_first = Cell::new(true);
        let geometry = |geometry| {
            let geometry = geometries::geometry(watched(geometry));
            if is_first.replace(false) {
                Box::new(First(geometry))
            } else {
                geometry
            }
        };
        let surface = |material| {
            Box::new(WatchedSurface(Watched {
                material,
                as_phong,
                is_lit_from_behind: false,
                all_work,
            })) as _
        };
        Self {
            world: materials::world(world, geometry, surface),
            all_work,
        }
    }
}

impl TracedWorld for WatchedWorld {
    fn radiance(&self, ray: &Ray, depth: u32) -> Color {
        NEXT.set(None);
        if self.all_work {
            NaiveTracer(&self.world).trace(ray, depth)
        } else {
            RecursiveTracer::new(&self.world).trace(ray, depth)
        }
    }

    fn watched(self: Box<Self>, _: bool) -> Box<dyn TracedWorld> {
        self
    }
}

/// The first geometry of a world.
#[derive(Debug)]
struct First(Box<dyn Geometry>);

impl Geometry for First {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        match NEXT.get() {
            Some(work) => tally::count(work),
            None => NEXT.set(Some(Work::ReflectedRay)),
        }
        self.0.hit(ray, within)
    }
}

/// A surface whose shadow rays and powers are counted.
#[derive(Debug)]
struct WatchedSurface(Watched<dyn Surface>);

impl Material for WatchedSurface {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        NEXT.set(Some(Work::ShadowRay));
        let color = self.0.color_for(ray, hit, lighting);
        NEXT.set(Some(Work::ReflectedRay));
        color
    }
}

impl Surface for WatchedSurface {
    fn reflection(&self) -> Color {
        self.0.material.reflection()
    }
}

/// The Phong material of a surface, if it has one.
fn as_phong(surface: &dyn Surface) -> Option<&Phong> {
    let any: &dyn Any = surface;
    let reflective = any.downcast_ref::<Reflective>();
    reflective.map_or_else(|| any.downcast_ref(), |surface| Some(&surface.shiny))
}
