//! `Condition`: how much the exact number of a case changes with the given numbers.

/// How much the exact number of a case changes with the given numbers, or why that cannot be said.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Condition {
    /// By how many units in its last place the exact number changes, if each given number changes by
    /// one: the sum of `|∂f/∂x · x / f|` over all given numbers x. Of three numbers, that which
    /// changes most counts, in units of the greatest.
    Known(f64),
    /// There is none, for this reason.
    Without(String),
    /// Nothing is said, which is enough for a decision, and for an exact value of 0.
    #[default]
    Unstated,
}
