//! Single keys of the terminal.

use std::io::{self, IsTerminal};
use std::sync::mpsc::{Receiver, channel};
use std::thread;

use console::{Key, Term};

/// Waits in the background for one key; elsewhere than on a terminal, for a line, of which
/// the first character counts. The end of the input disconnects.
///
/// The terminal sends keys instead of lines only while one is waited for.
pub fn ask() -> Receiver<char> {
    let (sender, typed) = channel();
    thread::spawn(move || read().map(|key| sender.send(key)));
    typed
}

fn read() -> Option<char> {
    let (input, terminal) = (io::stdin(), Term::stdout());
    if input.is_terminal() && terminal.is_term() {
        return Some(match terminal.read_key_raw().ok()? {
            Key::Char(key) => key,
            Key::Enter => '\n',
            Key::CtrlC => 'q',
            _ => ' ',
        });
    }
    input.lines().next()?.ok()?.chars().next().or(Some('\n'))
}
