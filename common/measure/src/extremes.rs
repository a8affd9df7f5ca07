//! Stiff and extreme cases: a table for the reader that is also a test.
//!
//! Each row computes one thing twice, by the protocol's formula and by ours,
//! and holds both against a value that neither has computed. The protocol's
//! must fail where the row says so: a comparison that it can't lose is none.

mod bound;
mod case;
mod outcome;
mod table;

pub use bound::Bound;
pub use case::{Case, Protocol};
pub use outcome::Outcome;
pub use table::{check, select};
