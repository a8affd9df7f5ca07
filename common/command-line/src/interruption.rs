//! Ctrl+C, or another program's wish that this one ends: the rendering stops, and what it has drawn is kept. A second
//! one ends the program at once, as any does while nothing is rendered.

use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

/// Begin to catch signals.
static HANDLERS: Once = Once::new();

/// Whether a signal ends the program.
static ENDS: AtomicBool = AtomicBool::new(true);

/// Whether a signal has stopped a rendering.
static STOPPED: AtomicBool = AtomicBool::new(false);

/// Renders a picture, which a signal stops.
pub fn stoppable<T>(render: impl FnOnce() -> T) -> T {
    HANDLERS.call_once(|| {
        for signal in [SIGINT, SIGTERM] {
            // If it fails, the signal ends the program.
            let _ = flag::register_conditional_default(signal, &ENDS)
                .and_then(|_| flag::register(signal, &STOPPED))
                .and_then(|_| flag::register(signal, &ENDS));
        }
    });
    ENDS.store(false, Ordering::Relaxed);
    let rendered = render();
    ENDS.store(true, Ordering::Relaxed);
    rendered
}

/// Whether a signal has stopped a rendering.
pub fn has_stopped() -> bool {
    STOPPED.load(Ordering::Relaxed)
}
