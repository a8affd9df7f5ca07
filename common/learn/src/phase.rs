//! `Phase`: what goes on while a file is checked.

use std::time::Duration;

/// What goes on.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Until another cargo has built.
    Waiting,
    Building,
    Checking,
    /// A picture, by the student's program.
    Drawing,
}

impl Phase {
    /// The words about it.
    pub fn words(self, elapsed: Duration) -> String {
        let seconds = elapsed.as_secs();
        let words = match self {
            Self::Waiting => "waiting for another cargo, which builds in this folder",
            Self::Building if seconds > 90 => "building all libraries, minutes at the first time",
            Self::Building if seconds > 4 => "building, about a minute",
            Self::Building => "building",
            Self::Checking => "checking",
            Self::Drawing => "drawing",
        };
        if seconds > 0 {
            format!("{words} ({seconds} s)")
        } else {
            words.to_owned()
        }
    }
}

/// Is told often how long the phase has lasted, and answers whether the check goes on.
pub type Watcher<'a> = &'a mut dyn FnMut(Phase, Duration) -> bool;
