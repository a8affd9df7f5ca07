//! `Effort`: how much is computed where more is only more certain.

/// How many rays, samples and rounds to spend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Seconds.
    Quick,
    /// The full counts.
    Full,
}

impl Effort {
    /// All in a release build; in a debug build, which is slower, little.
    #[must_use]
    pub const fn of_build() -> Self {
        if cfg!(debug_assertions) {
            Self::Quick
        } else {
            Self::Full
        }
    }

    /// One of two numbers.
    #[must_use]
    pub const fn choose(self, quick: usize, full: usize) -> usize {
        match self {
            Self::Quick => quick,
            Self::Full => full,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn little_effort_takes_the_first_number() {
        assert_eq!(Effort::Quick.choose(3, 15), 3);
        assert_eq!(Effort::Full.choose(3, 15), 15);
    }
}
