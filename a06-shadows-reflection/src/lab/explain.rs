//! The plans of this stage's scenes: which work a picture needs, and which work
//! the lesson leaves out compared with all work.

use std::any::Any;

use a03_rays_cameras::explain::samples;
use a04_intersections::explain::objects;
use a05_lighting::Phong;
use a05_lighting::explain::shading;
use common::{Color, Plan, Settings};

use crate::{LightSource, Reflective, ShadowedWorld, Surface};

/// The plan of a scene of the recursive tracer.
pub fn traced(world: &ShadowedWorld, settings: &Settings) -> Plan {
    let surfaces: Vec<&dyn Surface> = world.objects().objects().map(|(_, s)| &**s).collect();
    let materials: Vec<&dyn Any> = surfaces.iter().map(|surface| *surface as _).collect();
    let shiny = materials.iter().filter(|m| as_phong(**m).is_some()).count();
    let plan = objects(samples(settings), world.objects());
    let plan = shading(plan, world.lights().len(), &materials, shiny);
    reflections(shadows(plan, world.lights()), &surfaces)
}

fn shadows(mut plan: Plan, lights: &[LightSource]) -> Plan {
    let casting = lights.iter().filter(|light| light.casts_shadows()).count();
    if casting < lights.len() {
        let (others, all) = (lights.len() - casting, lights.len());
        plan = plan.without(
            format!("shadow rays to {others} of {all} lights"),
            "they cast no shadows",
        );
    }
    if casting == 0 {
        return plan;
    }
    plan.without(
        "shadow rays to lights behind the surface",
        "their light does not reach its front",
    )
    .without(
        "the search behind the first object between a surface and a light",
        "one object casts a shadow as well as two",
    )
}

fn reflections(plan: Plan, surfaces: &[&dyn Surface]) -> Plan {
    let is_black = |surface: &&&dyn Surface| surface.reflection() == Color::BLACK;
    let (black, all) = (surfaces.iter().filter(is_black).count(), surfaces.len());
    if black == 0 {
        return plan;
    }
    plan.without(
        format!("reflected rays from {black} of {all} objects"),
        "they do not mirror",
    )
}

/// The Phong material of a surface, if it has one.
pub fn as_phong(surface: &dyn Any) -> Option<&Phong> {
    match surface.downcast_ref() {
        Some(Reflective { shiny, .. }) => Some(shiny),
        None => surface.downcast_ref(),
    }
}
