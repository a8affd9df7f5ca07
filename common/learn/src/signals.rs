//! When a signal ends the program: ends what it runs, and gives the terminal back. While a key is waited for, a
//! terminal neither shows what is typed nor breaks its lines.

use std::io::{self, stdin};
use std::thread;

use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};
use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;

use crate::process;

/// From here on, such a signal leaves the terminal as it is at this moment, and no program behind.
pub fn clean_up_at_signals() -> io::Result<()> {
    // Elsewhere than on a terminal there is nothing to give back.
    let terminal = tcgetattr(stdin()).ok();
    let mut signals = Signals::new([SIGHUP, SIGINT, SIGQUIT, SIGTERM])?;
    thread::spawn(move || {
        for signal in signals.forever() {
            process::end_all(|| {
                // If it fails, nobody is there to be told.
                if let Some(before) = &terminal {
                    let _ = tcsetattr(stdin(), OptionalActions::Now, before);
                }
                let _ = emulate_default_handler(signal);
            });
        }
    });
    Ok(())
}
