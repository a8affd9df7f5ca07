//! `Effort`: how many rays an extreme case counts; more of them only make it more certain.

/// How many rays to spend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Few: all cases of a stage take seconds.
    Quick,
    /// The full counts.
    Full,
}

impl Effort {
    /// Full effort in a release build; quick in a debug build, which is slower.
    pub const fn of_build() -> Self {
        if cfg!(debug_assertions) {
            Self::Quick
        } else {
            Self::Full
        }
    }

    /// The number for this effort.
    pub const fn choose(self, quick: usize, full: usize) -> usize {
        match self {
            Self::Quick => quick,
            Self::Full => full,
        }
    }
}
