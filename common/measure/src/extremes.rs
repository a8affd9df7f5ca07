//! Stiff and extreme cases: a table for the reader that is also a test.
//!
//! Each row computes one quantity twice, by the protocol's formula and by ours, and
//! compares both with an exact value from another source. Where the row says so,
//! the protocol's formula must fail: otherwise the row would prove nothing.

mod against_protocol;
mod bound;
mod case;
mod condition;
mod outcome;
mod rows;
mod table;

pub use against_protocol::{AgainstProtocol, count_wrong};
pub use bound::Bound::{self, Absolute, Equal, Ulps};
pub use bound::ulp;
pub use case::Case;
pub use case::Protocol::{self, Fails, Holds};
pub use condition::Condition::{self, Known, Without};
pub use outcome::Outcome::{self, Flag, Nothing, Number, Refused, Triple};
pub use outcome::{greatest, tried};
pub use rows::{Row, rows};
pub use table::{check, select};
