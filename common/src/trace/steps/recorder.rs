//! The recorder of a thread, which counts the steps that wrappers report or writes them down.
//!
//! Each thread has a recorder of its own. Where it is off, a step costs one test of a flag.

use std::cell::{Cell, RefCell};

use super::StepKind;
use super::chosen_pixel::Choice;
use super::counts::Counts;
use super::trace::Trace;

/// What a recorder does with a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// Nothing.
    Off,
    /// Counts it.
    Counting,
    /// Writes it down.
    Tracing,
}

/// The recorder of a thread.
pub(super) struct Recorder {
    pub mode: Cell<Mode>,
    pub counts: Cell<Counts>,
    pub trace: RefCell<Trace>,
    /// The kind of the last step.
    pub last: Cell<Option<StepKind>>,
    pub choice: RefCell<Choice>,
}

thread_local! {
    pub(super) static RECORDER: Recorder = const {
        Recorder {
            mode: Cell::new(Mode::Off),
            counts: Cell::new(Counts::NONE),
            trace: RefCell::new(Trace::EMPTY),
            last: Cell::new(None),
            choice: RefCell::new(Choice::NONE),
        }
    };
}

/// The mode of this thread's recorder.
#[inline]
pub(super) fn mode() -> Mode {
    RECORDER.with(|recorder| recorder.mode.get())
}

/// The kind of the last step that this thread has reported.
#[must_use]
pub fn last() -> Option<StepKind> {
    RECORDER.with(|recorder| recorder.last.get())
}
