//! Rays that broke ray tracers, with exact answers: the reader of `cases.toml`, and the verdict
//! about an answer. `README.md` beside this crate describes the file.

mod case;
mod reader;
pub mod results;
mod row;
mod verdict;

pub use case::{Answer, Case, Hit, Question, Shape, Step};
pub use reader::{Mistake, read, read_rows};
pub use results::table;
pub use row::{Asks, Bound, Distance, Expected, Outlook, Row, rows};
pub use verdict::{DOUBLE, Found, SINGLE, Tally, Verdict, judge};

/// The text of `cases.toml`, whose numbers are doubles.
pub const CASES: &str = include_str!("../cases.toml");

/// The text of `single.toml`: the same cases with every number rounded to single precision, and with
/// the exact answers of these numbers. A case is left out where this rounding leaves no shape.
pub const SINGLE_CASES: &str = include_str!("../single.toml");

/// The text of `laboratory.toml`: the cases of the stages' laboratories, with what they expect of the
/// lesson and of the course's protocol.
pub const LABORATORY: &str = include_str!("../laboratory.toml");
