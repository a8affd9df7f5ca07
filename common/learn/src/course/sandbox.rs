//! `Sandbox`: runs programs that nobody trusts, with limits, and without network and files of
//! others where bubblewrap is installed.

use std::fs::{self, File};
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::files::failed;

/// The limits, and how they are set.
const SCRIPT: &str = include_str!("../../handout/sandbox.sh");

/// The warning about plain limits.
pub const NOTE: &str = "note: bubblewrap (bwrap) does not run here, so submissions have limits of \
    time, memory and file size only: they can read and delete your files, use the network, and \
    start and leave behind any number of processes; install it, or grade in a container that you throw away";

/// A folder with the `workbook` and the `target` of its builds.
pub struct Sandbox {
    pub folder: PathBuf,
}

impl Sandbox {
    /// The file with the output of the last program.
    pub fn output(&self) -> PathBuf {
        self.folder.join("output")
    }

    /// Runs a program with the limits of a kind, and returns its output. The student's code
    /// prints its answers to one exercise.
    ///
    /// The error is a message to the student, and begins with `fails` if the program ends by
    /// itself.
    pub fn run(
        &self,
        kind: &str,
        exercise: &str,
        program: &[&str],
        fails: &str,
    ) -> Result<String, String> {
        let path = self.output();
        let output = File::create(&path).map_err(failed(&path))?;
        let errors = output.try_clone().map_err(failed(&path))?;
        let mut sandbox = Command::new("sh");
        sandbox.args(["-c", SCRIPT, "sh", kind]).arg(&self.folder);
        sandbox.args(program).env("EXERCISE_PRINTED", exercise);
        sandbox.stdin(Stdio::null()).stdout(output).stderr(errors);
        let ended = sandbox.status().map_err(|error| format!("sh: {error}"))?;
        let said = fs::read(&path).map_err(failed(&path))?;
        let said = String::from_utf8_lossy(&said).into_owned();
        let why = match ended.code() {
            Some(0) => return Ok(said),
            Some(3) => "begun",
            Some(code) if code < 124 => fails,
            // By `timeout`, or by a signal.
            _ => "stopped by a limit of time, memory, processes or the size of a file",
        };
        // Messages of Cargo, and answers.
        let is_hidden = |line: &str| line.is_empty() || line.starts_with(['{', '\u{1d}']);
        let said = said.lines().filter(|line| !is_hidden(line));
        Err([why].into_iter().chain(said).collect::<Vec<_>>().join("\n"))
    }
}
