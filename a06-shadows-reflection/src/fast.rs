//! Translates the surfaces and light sources of this stage for the engine.

use std::any::Any;

use a03_rays_cameras::Ray;
use a04_intersections::Hit;
use a04_intersections::fast::{Translate, add_objects};
use a05_lighting::fast::{light, shading};

use crate::{RecursiveTracer, Reflective, ShadowedWorld, Surface};

/// A world as a scene of the engine, whose rays may hit `depth` surfaces in turn.
/// `shapes` translates its geometries.
#[must_use]
pub fn scene(world: &ShadowedWorld, depth: u32, shapes: Translate) -> engine::Scene<'_> {
    let mut scene = engine::Scene::new(world.objects().background(), world.ambient(), depth);
    add_objects(&mut scene, world.objects(), shapes, |surface| {
        self::surface(&**surface, world)
    });
    for source in world.lights() {
        scene.add_light(engine::Light {
            kind: light(&*source.light),
            casts_shadows: source.casts_shadows(),
        });
    }
    scene
}

/// The engine's surface: numbers if the engine has the surface's type, otherwise a
/// function that shades each hit with the light of the lesson's tracer.
fn surface<'a>(surface: &'a dyn Surface, world: &'a ShadowedWorld) -> engine::Surface<'a> {
    let any: &dyn Any = surface;
    let color = move |ray: &Ray, hit: &Hit| {
        let lighting = RecursiveTracer::new(world);
        surface.color_for(ray, hit, &lighting)
    };
    engine::Surface {
        shading: match any.downcast_ref::<Reflective>() {
            Some(reflective) => (&reflective.shiny).into(),
            None => shading(surface, color),
        },
        reflection: surface.reflection(),
    }
}
