//! Prints lines on stdout and stderr.

use std::io::{self, ErrorKind, Write};
use std::path::Path;

use common::{Error, atomic_file, text};

/// Prints a text on stdout, in which a terminal obeys no character but newlines. A closed pipe is no
/// error: its reader has ended.
pub fn print(line: &str) -> Result<(), Error> {
    ignore_broken_pipe(writeln!(io::stdout(), "{}", text::visible_lines(line)))
}

/// Ignores a closed pipe, whose reader has ended; other output that is lost is an error.
pub fn ignore_broken_pipe(outcome: io::Result<()>) -> Result<(), Error> {
    match outcome {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let stdout = Path::new("standard output");
            Err(atomic_file::cannot_write(stdout, &error))
        }
        _ => Ok(()),
    }
}

/// Prints a text on stderr as [`text::message`]. Where stderr is broken, there is no place left to say
/// so.
pub fn warn(line: &str) {
    let _ = writeln!(io::stderr(), "{}", text::message(line));
}
