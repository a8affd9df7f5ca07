//! A program run as a child, and the memory it takes.

use std::fs::{self, File};
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// How often a child is looked at: seldom enough not to disturb it, and often
/// enough not to miss its memory.
const INTERVAL: Duration = Duration::from_millis(2);

/// The output of a child, and its memory.
pub struct Outcome {
    /// All that it printed.
    pub log: String,
    /// The most memory it has held at once, in bytes, as last seen.
    pub peak: u64,
}

/// Runs a program to its end, or ends it after `limit`: then there is no outcome.
pub fn run(command: &mut Command, log: &Path, limit: Duration) -> io::Result<Option<Outcome>> {
    let file = File::create(log)?;
    command
        .stdin(Stdio::null())
        .stderr(file.try_clone()?)
        .stdout(file);
    let mut child = command.spawn()?;
    let (started, mut peak) = (Instant::now(), 0);
    while child.try_wait()?.is_none() {
        if started.elapsed() > limit {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        peak = peak.max(peak_memory(child.id()).unwrap_or(0));
        thread::sleep(INTERVAL);
    }
    let log = String::from_utf8_lossy(&fs::read(log)?).into_owned();
    Ok(Some(Outcome { log, peak }))
}

/// The greatest resident memory of a running process so far, where the system
/// reports it (Linux: `VmHWM`, in KiB).
fn peak_memory(process: u32) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kib: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kib * 1024)
}
