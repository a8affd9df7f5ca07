//! The laboratory of stage 2: measures the lesson, and is no part of it.

#![doc(hidden)]
#![expect(clippy::must_use_candidate, reason = "called by reports and tests")]

mod experiments;
mod extremes;
pub mod protocol;
pub mod sweeps;

use measure::Laboratory;

/// The laboratory for its program.
#[must_use]
pub fn laboratory() -> Laboratory {
    Laboratory {
        stage: a02_math::stage(),
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}
