//! The laboratory of stage 4: measures the lesson, and is no part of it.

#![doc(hidden)]
#![expect(clippy::must_use_candidate, reason = "called by reports and tests")]

pub mod aimed_box;
pub mod closed_mesh;
pub mod compared_shape;
pub mod exact;
pub mod experiments;
mod extremes;
pub mod formula;
pub mod line;
pub mod mesh;
pub mod number;
pub mod protocol;
pub mod rows;
pub mod support;
pub mod sweeps;

use measure::Laboratory;

/// The laboratory for its program.
#[must_use]
pub fn laboratory() -> Laboratory {
    Laboratory {
        stage: a04_intersections::stage(),
        experiments: experiments::experiments,
        extremes: extremes::cases,
    }
}
