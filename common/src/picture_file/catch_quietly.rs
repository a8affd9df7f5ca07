//! `catch_quietly`: catches panics of foreign code without a message; `tests/broken.rs`
//! tests it.

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

thread_local! {
    static IS_CATCHING: Cell<bool> = const { Cell::new(false) };
}

/// The result of `work`, or none if it panics. The panic prints no message; panics of
/// other threads print theirs as usual.
pub fn catch_quietly<T>(work: impl FnOnce() -> T) -> Option<T> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let loud = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if !IS_CATCHING.get() {
                loud(info);
            }
        }));
    });
    IS_CATCHING.set(true);
    // Unwinding drops all that the work could have left in a broken state.
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    IS_CATCHING.set(false);
    outcome.ok()
}
