//! The pictures of an open sheet, judged by facts that follow from theory.
//!
//! A sheet is a file such as `sheets/glass.toml`: the pictures that the student's program draws, and the facts
//! that they are asked, each with its formula, value and tolerance. This module reads the sheets, asks the facts
//! and says what is wrong.

mod autocorrelation;
mod fact;
mod fitted_slope;
mod judgement;
mod last_words;
mod line;
mod marked_copy;
mod quantity;
mod report;
mod run;
mod sheet;
mod theory;
mod values;

pub use fact::Fact;
pub use fitted_slope::Axis;
pub use judgement::{Drawn, Facts, Judgement, State, ask_facts};
pub use last_words::{last_words, no_picture};
pub use marked_copy::MARKED_EXTENSION;
pub use run::Run;
pub use sheet::{RequestedPicture, Sheet};
pub use theory::{PixelErrors, Precision, Theory};

/// The names of the sheets, in the order in which they are set.
pub const NAMES: [&str; 7] = [
    "lens", "cores", "patterns", "tree", "glass", "lamp", "light",
];
