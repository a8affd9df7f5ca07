//! The laboratory of stage 6: measures the lesson, and is no part of it.

#![doc(hidden)]
#![expect(clippy::must_use_candidate, reason = "called by reports and tests")]

pub mod coarse_ball;
pub mod experiments;
mod extremes;
pub mod lit_points;
mod mirrors;
pub mod policy;
pub mod protocol;
pub mod surface;

use measure::Laboratory;

/// The laboratory for its program.
#[must_use]
pub fn laboratory() -> Laboratory {
    Laboratory {
        stage: a06_shadows_reflection::stage(),
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}
