//! `Shown`: a program on a private X server, for a test that sees its window and uses
//! keyboard and mouse as a person does.
//!
//! The screen is read from the file in which Xvfb stores it. That is fast, so a test
//! looks again and again until the screen is as expected; it never waits for a time.

mod picture;
mod server;
mod shown;

use std::time::{Duration, Instant};

pub use picture::Picture;
pub use shown::Shown;

/// After this time a test stops waiting and fails.
const PATIENCE: Duration = Duration::from_mins(1);

/// Waits until `find` returns a value; fails after a minute, with `what` in the message.
pub fn wait_for<T>(what: &str, mut find: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(found) = find() {
            return found;
        }
        assert!(start.elapsed() < PATIENCE, "waited in vain: {what}");
        std::thread::sleep(Duration::from_millis(5));
    }
}
