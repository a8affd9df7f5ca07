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
    /// The kind of the ray that the world is searched for next, after a light or a surface.
    expected_ray: Cell<Option<StepKind>>,
    pub choice: RefCell<Choice>,
}

thread_local! {
    pub(super) static RECORDER: Recorder = const {
        Recorder {
            mode: Cell::new(Mode::Off),
            counts: Cell::new(Counts::NONE),
            trace: RefCell::new(Trace::EMPTY),
            expected_ray: Cell::new(None),
            choice: RefCell::new(Choice::NONE),
        }
    };
}

/// The mode of this thread's recorder.
#[inline]
pub(super) fn mode() -> Mode {
    RECORDER.with(|recorder| recorder.mode.get())
}

/// Says, before the world is searched, which kind of ray it will be searched for: the tracer's
/// wrappers know that a light is asked before its shadow ray is sent, and that a surface is left by
/// a reflected ray. None says that the next ray is reported by itself.
pub fn expect_ray(kind: Option<StepKind>) {
    RECORDER.with(|recorder| recorder.expected_ray.set(kind));
}

/// Takes the kind of ray that is expected: a search of the world begins.
#[must_use]
pub fn take_expected_ray() -> Option<StepKind> {
    RECORDER.with(|recorder| recorder.expected_ray.take())
}
