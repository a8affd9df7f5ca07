//! The plans of this stage's scenes: which rays a picture needs, and which work
//! the lesson leaves out compared with all work.

use common::{Bound, Plan, Settings};

use crate::Sampler;

/// The plan of the rays from the camera.
pub fn samples(settings: &Settings) -> Plan {
    if let Some(error) = settings.max_error {
        let need = format!("primary rays: as many as an error of {error} takes");
        return Plan::default().needing(need).nearly_without(
            "samples where others agree",
            "new samples of pixels drawn at random check the error of the picture; the error of \
             a single pixel may be larger",
            Bound::Error(error),
        );
    }
    let samples = Sampler::new(settings).samples();
    let rays = settings.size.pixels() as u64 * u64::from(samples);
    let plan = Plan::default().needing(format!("primary rays: {rays}, {samples} per pixel"));
    if settings.sampling.is_random() {
        plan
    } else {
        plan.without("random numbers", "every sample has a fixed place")
    }
}

/// The plan of the striped sky.
pub fn sky(settings: &Settings) -> Plan {
    samples(settings).without(
        "intersections, lights and mirrors",
        "the scene has a sky and no objects",
    )
}
