//! The plans of this stage's scenes: which work a picture needs, and which work
//! the lesson leaves out compared with all work.

use a03_rays_cameras::explain;
use common::{Color, Plan, Settings};

use crate::World;

/// Adds the objects of a world to a plan.
pub fn objects<S>(plan: Plan, world: &World<S>) -> Plan {
    plan.needing(format!("objects: {}", world.objects().count()))
}

/// The plan of a world of colours.
pub fn colors(world: &World<Color>, settings: &Settings) -> Plan {
    objects(explain::samples(settings), world).without(
        "lights and mirrors",
        "objects have a colour and no material",
    )
}
