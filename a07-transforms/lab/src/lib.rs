//! The laboratory of stage 7: measures the lesson, and is no part of it.

#![doc(hidden)]
#![expect(clippy::must_use_candidate, reason = "called by reports and tests")]

pub mod asked;
pub mod errata;
mod experiments;
mod extremes;
pub mod go_wrong;
pub mod protocol;
mod side_by_side;
pub mod sweeps;

use measure::Laboratory;

/// The laboratory for its program.
#[must_use]
pub fn laboratory() -> Laboratory {
    Laboratory {
        stage: a07_transforms::stage(),
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}
