//! Prints lines on stdout and stderr.

use std::io::{self, ErrorKind, Write};
use std::path::Path;

use common::{Error, atomic_file, text};

/// Prints a text on stdout, in which a terminal obeys no character but newlines. A closed pipe is no error: its reader has ended.
pub fn print(line: &str) -> Result<(), Error> {
    printed(writeln!(io::stdout(), "{}", text::visible_lines(line)))
}

/// The error of output that is lost, unless its reader has ended.
pub fn printed(outcome: io::Result<()>) -> Result<(), Error> {
    match outcome {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let stdout = Path::new("standard output");
            Err(atomic_file::cannot_write(stdout, &error))
        }
        _ => Ok(()),
    }
}

/// Prints a text on stderr as [`text::message`]. Nobody could read of an error there.
pub fn warn(line: &str) {
    let _ = writeln!(io::stderr(), "{}", text::message(line));
}
