//! Rays that broke ray tracers, with exact answers: the reader of `cases.toml`, and the verdict
//! about an answer. `README.md` beside this crate describes the file.

mod case;
mod reader;
mod verdict;

pub use case::{Case, ExactAnswer, Hit, Question, Shape, Step};
pub use reader::read;
pub use verdict::{DOUBLE, Verdict, verdict};

/// The text of `cases.toml`, whose numbers are doubles.
pub const CASES: &str = include_str!("../cases.toml");

/// The text of `single.toml`: the same cases with every number rounded to single precision, and with
/// the exact answers of these numbers. A case is left out where this rounding leaves no shape.
pub const SINGLE_CASES: &str = include_str!("../single.toml");
