//! `catch_quietly`: what others have written may panic, and must not end the program.

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::sync::Once;

thread_local! {
    static IS_CATCHING: Cell<bool> = const { Cell::new(false) };
}

/// What `work` returns, or none if it panics. Of that nothing is printed;
/// panics of other threads are as loud as ever.
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
    // Whatever the work was on is gone with it.
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    IS_CATCHING.set(false);
    outcome.ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_none_and_the_next_work_is_done() {
        assert_eq!(catch_quietly(|| assert_eq!(1 + 1, 3)), None);
        assert_eq!(catch_quietly(|| 1 + 1), Some(2));
    }
}
