//! `run`: runs a program within limits, and stops it on request.

use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::time::Duration;
use std::{io, thread};

/// Time between two looks at a running program.
const PAUSE: Duration = Duration::from_millis(10);

/// The most memory of a student's program. Windows and macOS do not hold this limit.
const KIB: u32 = 2 << 20;

/// The command that runs a program with a limit of memory, where a shell can set one.
pub fn limited(program: &Path) -> Command {
    if !cfg!(unix) {
        return Command::new(program);
    }
    let mut shell = Command::new("sh");
    // Some shells end where a limit cannot be set.
    let script = format!(
        "(ulimit -d {KIB}) 2>/dev/null && ulimit -d {KIB}; ulimit -c 0; exec \"$0\" \"$@\""
    );
    shell.args(["-c", &script]).arg(program);
    shell
}

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
