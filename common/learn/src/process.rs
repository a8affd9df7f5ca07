//! `run`: runs a program within limits, and ends it on request.

use std::collections::BTreeSet;
#[cfg(unix)]
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use std::{io, thread};

#[cfg(unix)]
use rustix::process::{Pid, Signal, kill_process_group};

/// The times between two looks at a running program: a hundredth of its time so far, which is then known to 1 %.
const LEAST_PAUSE: Duration = Duration::from_micros(200);
const MOST_PAUSE: Duration = Duration::from_millis(10);

/// The most memory of a student's program. Windows and macOS do not hold this limit.
const MAX_KIB: u32 = 2 << 20;

/// The command that runs a program with a limit of memory, where a shell can set one.
pub fn limited(program: &Path) -> Command {
    if !cfg!(unix) {
        return Command::new(program);
    }
    let mut shell = Command::new("sh");
    // Some shells end where a limit cannot be set.
    let script = format!(
        "(ulimit -d {MAX_KIB}) 2>/dev/null && ulimit -d {MAX_KIB}; ulimit -c 0; exec \"$0\" \"$@\""
    );
    shell.args(["-c", &script]).arg(program);
    shell
}

/// The programs that run, by the numbers of their processes. On Unix each is the first of a group, in which are
/// all that it starts, such as a compiler.
static RUNNING: Mutex<BTreeSet<u32>> = Mutex::new(BTreeSet::new());

fn running() -> MutexGuard<'static, BTreeSet<u32>> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends all programs, and does something before another one can begin.
#[cfg(unix)]
pub fn end_all(afterwards: impl FnOnce()) {
    let running = running();
    running.iter().for_each(|id| end_group(*id));
    afterwards();
}

#[cfg(unix)]
fn end_group(id: u32) {
    // If it fails, the group has ended.
    if let Some(id) = Pid::from_raw(id as i32) {
        let _ = kill_process_group(id, Signal::KILL);
    }
}

/// Runs a program without input until it ends, or until `goes_on` is false: then there is no
/// status. All that it has started ends with it. Its pipes are closed on this side.
pub fn run(command: Command, goes_on: &mut dyn FnMut() -> bool) -> io::Result<Option<ExitStatus>> {
    let start = Instant::now();
    let mut child = begin(command)?;
    loop {
        if let Some(status) = status(&mut child)? {
            return Ok(Some(status));
        }
        if !goes_on() {
            end(&mut child)?;
            return Ok(None);
        }
        thread::sleep((start.elapsed() / 100).clamp(LEAST_PAUSE, MOST_PAUSE));
    }
}

fn begin(mut command: Command) -> io::Result<Child> {
    #[cfg(unix)]
    command.process_group(0);
    let mut running = running();
    let child = command.stdin(Stdio::null()).spawn()?;
    running.insert(child.id());
    Ok(child)
}

fn status(child: &mut Child) -> io::Result<Option<ExitStatus>> {
    let mut running = running();
    let status = child.try_wait()?;
    if status.is_some() {
        #[cfg(unix)]
        end_group(child.id());
        running.remove(&child.id());
    }
    Ok(status)
}

fn end(child: &mut Child) -> io::Result<()> {
    let mut running = running();
    #[cfg(unix)]
    end_group(child.id());
    #[cfg(not(unix))]
    child.kill()?;
    child.wait()?;
    running.remove(&child.id());
    Ok(())
}
