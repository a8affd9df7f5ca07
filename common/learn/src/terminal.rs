//! Gives the terminal back when a signal ends the program: while a key is waited for, a terminal neither shows
//! what is typed nor breaks its lines.

use std::io::{self, stdin};
use std::thread;

use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};
use signal_hook::consts::{SIGHUP, SIGTERM};
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;

/// From here on, such a signal leaves the terminal as it is at this moment. Elsewhere than on a terminal it does
/// what it does by default.
pub fn give_back_at_signals() -> io::Result<()> {
    let Ok(before) = tcgetattr(stdin()) else {
        return Ok(());
    };
    let mut signals = Signals::new([SIGTERM, SIGHUP])?;
    thread::spawn(move || {
        for signal in signals.forever() {
            // If it fails, nobody is there to be told.
            let _ = tcsetattr(stdin(), OptionalActions::Now, &before);
            let _ = emulate_default_handler(signal);
        }
    });
    Ok(())
}
