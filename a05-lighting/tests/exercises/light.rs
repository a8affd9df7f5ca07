//! Asks lights, point by point.

use std::sync::Arc;

use crate::prelude::*;

/// The light that arrives at a point.
pub type Arriving = Option<Illumination>;

/// The light of some parameters that arrives at a point.
pub type LightAt<P> = Arc<dyn Fn(P, Point3) -> Arriving + Send + Sync>;

/// The code that computes light by this function.
pub fn light_at<P>(light: impl Fn(P, Point3) -> Arriving + Send + Sync + 'static) -> LightAt<P> {
    Arc::new(light)
}

/// An exercise whose file asks lights of some parameters, and points to which they shine.
pub fn lights<P: Input + Default + 'static>() -> Exercise<LightAt<P>> {
    Exercise::asked(|light: &LightAt<P>, (parameters, p): (P, [f64; 3])| {
        light_answer(light(parameters, point(p)))
    })
}

/// Light as an answer.
fn light_answer(light: Arriving) -> Answer {
    light.map_or(Answer::words("no light"), |light| {
        Answer::named("colour", light.color.channels())
            .and("direction", array(light.direction))
            .and("distance", light.distance)
    })
}
