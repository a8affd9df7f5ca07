//! `Keys`: single keys of the terminal.

use std::io::{self, IsTerminal};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use console::{Key, Term};

/// What came from the keyboard.
pub enum Typed {
    Key(Key),
    /// No key within the time.
    Nothing,
    /// The input has ended: no key will come.
    End,
}

/// The keyboard. Elsewhere than on a terminal, a line is a key: its first character, or Enter.
///
/// The terminal sends keys instead of lines only while one is waited for. So at the end of the
/// program none is: it ends after a key.
#[derive(Default)]
pub struct Keys {
    awaited: Option<Receiver<Key>>,
}

impl Keys {
    /// Waits for a key.
    pub fn read(&mut self, longest: Duration) -> Typed {
        let awaited = self.awaited.get_or_insert_with(await_key);
        match awaited.recv_timeout(longest) {
            Ok(key) => {
                self.awaited = None;
                Typed::Key(key)
            }
            Err(RecvTimeoutError::Timeout) => Typed::Nothing,
            Err(RecvTimeoutError::Disconnected) => Typed::End,
        }
    }
}

/// Waits in the background for one key.
fn await_key() -> Receiver<Key> {
    let (sender, awaited) = channel();
    thread::spawn(move || {
        if let Some(key) = read_key() {
            // Nobody waits for it at the end of the program.
            let _ = sender.send(key);
        }
    });
    awaited
}

fn read_key() -> Option<Key> {
    let input = io::stdin();
    let terminal = Term::stdout();
    if input.is_terminal() && terminal.is_term() {
        return terminal.read_key_raw().ok();
    }
    let line = input.lines().next()?.ok()?;
    Some(line.chars().next().map_or(Key::Enter, Key::Char))
}
