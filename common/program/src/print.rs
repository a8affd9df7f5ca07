//! Prints lines on stdout and stderr.

use std::io::{self, Write};

/// Prints a line on stdout. A closed pipe is no error: its reader has ended.
pub fn print(line: &str) {
    let _ = writeln!(io::stdout(), "{line}");
}

/// Prints a line on stderr. A closed pipe is no error there either.
pub fn warn(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}
