//! Stiff and extreme cases: a table for the reader that is also a test.
//!
//! Each row computes one quantity twice, by the protocol's formula and by ours, and
//! compares both with an exact value from another source. Where the row says so,
//! the protocol's formula must fail: otherwise the row would prove nothing.

mod bound;
mod case;
mod outcome;
mod table;

pub use bound::Bound;
pub use case::{Case, Protocol};
pub use outcome::Outcome;
pub use table::{check, select};
