//! The plans of this stage's scenes: which work a picture needs, and which work
//! the lesson leaves out compared with all work.

use std::any::Any;

use a03_rays_cameras::explain::samples;
use a04_intersections::explain::objects;
use common::{Plan, Settings};

use crate::lab::highlight::as_phong;
use crate::{LitWorld, SingleColor};

/// The plan of a scene of this stage.
pub fn scene(world: &LitWorld, settings: &Settings) -> Plan {
    let plan = objects(samples(settings), world.objects());
    let materials: Vec<_> = world.objects().objects().map(|(_, m)| &**m as _).collect();
    let shiny = materials.iter().filter(|m| as_phong(**m).is_some()).count();
    shading(plan, world.lights().len(), &materials, shiny).without(
        "shadows and mirrors",
        "the lights and materials of this stage have none",
    )
}

/// Adds the shading of these materials to a plan; `shiny` of them have a highlight.
pub fn shading(plan: Plan, lights: usize, materials: &[&dyn Any], shiny: usize) -> Plan {
    let mut plan = plan.needing(format!("lights: {lights}"));
    if lights == 0 {
        return plan.without("all shading by lights", "there are no lights");
    }
    let single = materials.iter().filter(|m| m.is::<SingleColor>()).count();
    if single > 0 {
        plan = plan.without(
            format!("light on {single} of {} objects", materials.len()),
            "their colour does not depend on it",
        );
    }
    if shiny > 0 {
        plan = plan.without(
            "powers where the light is mirrored away from the eye or comes from behind",
            "there is no highlight",
        );
    }
    plan
}
