//! `AgainstProtocol`: our result beside the protocol's.

/// Our result and that of the protocol's formula.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AgainstProtocol<T> {
    /// The result of the lesson, or of a formula that it recommends.
    pub ours: T,
    /// The result of the protocol's formula.
    pub theirs: T,
}

impl<T> AgainstProtocol<T> {
    /// Both results by the same function.
    pub fn map<U>(self, mut function: impl FnMut(T) -> U) -> AgainstProtocol<U> {
        AgainstProtocol {
            ours: function(self.ours),
            theirs: function(self.theirs),
        }
    }
}

/// Of some trials, the number for which each of two decisions is wrong.
pub fn count_wrong<T, E>(
    trials: impl IntoIterator<Item = T>,
    is_wrong: impl Fn(T) -> Result<AgainstProtocol<bool>, E>,
) -> Result<AgainstProtocol<usize>, E> {
    let mut counts = AgainstProtocol::default();
    for trial in trials {
        let is_wrong = is_wrong(trial)?;
        counts.ours += usize::from(is_wrong.ours);
        counts.theirs += usize::from(is_wrong.theirs);
    }
    Ok(counts)
}
