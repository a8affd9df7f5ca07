//! `run`: runs a program, and stops it on request.

use std::process::{Command, ExitStatus, Stdio};
use std::time::Duration;
use std::{io, thread};

/// Time between two looks at a running program.
const PAUSE: Duration = Duration::from_millis(10);

/// Runs a program without input until it ends, or until `goes_on` is false: then there is no
/// status. Its pipes are closed on this side.
pub fn run(
    mut command: Command,
    goes_on: &mut dyn FnMut() -> bool,
) -> io::Result<Option<ExitStatus>> {
    let mut child = command.stdin(Stdio::null()).spawn()?;
    drop(command);
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if !goes_on() {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        thread::sleep(PAUSE);
    }
}
