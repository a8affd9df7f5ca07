//! `catch_quietly`: catches panics of foreign code, which must not end the program.

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_yields_none_and_later_work_is_done() {
        assert_eq!(catch_quietly(|| assert_eq!(1 + 1, 3)), None);
        assert_eq!(catch_quietly(|| 1 + 1), Some(2));
    }
}
