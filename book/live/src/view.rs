//! The views of the traced pictures, and the surface that a ray meets.

use std::any::Any;
use std::fmt::Debug;

use a02_math::Point3;
use a03_rays_cameras::{Ray, View};
use a04_intersections::{Geometry, Hit, Interval, World};
use a05_lighting::LitWorld;
use a06_shadows_reflection::RecursiveWorld;
use common::{ArgumentError, Color, Settings};

use crate::catalogue;

/// The view of a picture; none if the picture is not a traced scene of a stage.
pub fn view(picture: &str, settings: &Settings) -> Result<Option<View>, ArgumentError> {
    let scene = catalogue::traced_scene(picture);
    scene.map(|scene| (scene.view)(settings.size)).transpose()
}

/// The point that the camera of a picture is turned around.
pub fn centre(picture: &str) -> Point3 {
    // The objects that a camera at the origin looks at are three to six before it.
    match picture {
        "a04-intersections-scene-2" | "a04-intersections-scene-4" => Point3::new(0.0, 0.0, -3.0),
        "a04-intersections-scene-5" | "a04-intersections-scene-6" => Point3::new(0.0, 0.0, -4.5),
        _ => Point3::ORIGIN,
    }
}

/// The surface that a ray has met.
pub struct Met {
    pub hit: Hit,
    /// The types of the geometry and of its material.
    pub names: String,
}

/// The nearest surface along a ray; none also in a world without surfaces.
pub fn meet(view: &View, ray: &Ray) -> Option<Met> {
    let world: &dyn Any = &*view.world;
    if let Some(world) = world.downcast_ref::<World<Color>>() {
        nearest(world, ray, |_| String::new())
    } else if let Some(world) = world.downcast_ref::<LitWorld>() {
        nearest(world.objects(), ray, material)
    } else {
        let RecursiveWorld { world, .. } = world.downcast_ref()?;
        nearest(world.objects(), ray, material)
    }
}

fn nearest<S>(world: &World<S>, ray: &Ray, material: impl Fn(&S) -> String) -> Option<Met> {
    let (hit, _) = world.hit(ray, Interval::AHEAD)?;
    // The world says where, and the geometry of the same `t` which.
    let at_hit = |geometry: &dyn Geometry| {
        let own = geometry.hit(ray, Interval::AHEAD);
        own.is_some_and(|own| own.t == hit.t)
    };
    let (geometry, surface) = world.objects().find(|(geometry, _)| at_hit(*geometry))?;
    let names = format!("{}{}", type_name(geometry), material(surface));
    Some(Met { hit, names })
}

fn material(surface: &impl Debug) -> String {
    format!(", {}", type_name(surface))
}

/// The name of a type, with which its `Debug` text begins.
fn type_name(value: &(impl Debug + ?Sized)) -> String {
    let text = format!("{value:?}");
    let name = text.split(|c: char| !c.is_alphanumeric()).next();
    name.unwrap_or_default().to_owned()
}
