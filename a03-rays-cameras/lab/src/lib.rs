//! The laboratory of stage 3: measures the lesson, and is no part of it.

#![doc(hidden)]
#![expect(clippy::must_use_candidate, reason = "called by reports and tests")]

pub mod experiments;
mod extremes;
pub mod protocol;

use measure::Laboratory;

/// The laboratory for its program.
#[must_use]
pub fn laboratory() -> Laboratory {
    Laboratory {
        stage: a03_rays_cameras::stage(),
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}
