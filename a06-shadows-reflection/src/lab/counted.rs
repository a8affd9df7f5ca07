//! Counts shadow rays, reflected rays and powers, by wrappers around the objects
//! and a geometry that is tested in every search of the world.

use std::cell::Cell;

use a03_rays_cameras::{Camera, Ray};
use a04_intersections::{Geometry, Hit, Interval, counted};
use a05_lighting::counted::counted_powers;
use a05_lighting::{Lighting, Material, SingleColor};
use common::tally::{self, Work};
use common::{ArgumentError, Color, Settings, Size};

use crate::lab::explain::as_phong;
use crate::{ShadowedWorld, Surface};

thread_local! {
    /// Whether the next search of the world is for a ray from the camera.
    static IS_PRIMARY: Cell<bool> = const { Cell::new(false) };
    /// Whether a surface is being shaded.
    static IS_SHADING: Cell<bool> = const { Cell::new(false) };
}

/// Wraps this camera to count the work of a rendering with these settings.
pub fn camera(camera: Box<dyn Camera>, settings: &Settings) -> Box<dyn Camera> {
    Box::new(MarkedCamera(a03_rays_cameras::counted::camera(
        camera, settings,
    )))
}

struct MarkedCamera(Box<dyn Camera>);

impl Camera for MarkedCamera {
    fn ray_for(&self, size: Size, x: f64, y: f64) -> Ray {
        IS_PRIMARY.set(true);
        self.0.ray_for(size, x, y)
    }
}

/// Wraps the objects of a world to count its work.
pub fn world(world: ShadowedWorld) -> Result<ShadowedWorld, ArgumentError> {
    let (objects, lights, ambient) = world.into_parts();
    let mut probed = ShadowedWorld::empty(objects.background(), ambient)?
        .with(Probe, Box::new(SingleColor::new(Color::BLACK)?));
    for (geometry, surface) in objects.into_objects() {
        probed = probed.with(counted::geometry(geometry), Box::new(Counted(surface)));
    }
    Ok(lights.into_iter().fold(probed, ShadowedWorld::lit_by))
}

/// The first geometry of the world, which no ray hits: it counts the searches.
#[derive(Debug)]
struct Probe;

impl Geometry for Probe {
    fn hit(&self, _: &Ray, _: Interval) -> Option<Hit> {
        if IS_SHADING.get() {
            tally::count(Work::ShadowRay);
        } else if !IS_PRIMARY.replace(false) {
            tally::count(Work::ReflectedRay);
        }
        None
    }
}

/// A surface that sets a flag while it is shaded, and counts powers.
#[derive(Debug)]
struct Counted(Box<dyn Surface>);

impl Material for Counted {
    fn color_for(&self, ray: &Ray, hit: &Hit, lighting: &dyn Lighting) -> Color {
        IS_SHADING.set(true);
        let color = counted_powers(as_phong(&*self.0), lighting, |lighting| {
            self.0.color_for(ray, hit, lighting)
        });
        IS_SHADING.set(false);
        color
    }
}

impl Surface for Counted {
    fn reflection(&self) -> Color {
        self.0.reflection()
    }
}
