//! `Sandbox`: runs programs that nobody trusts, with limits, and without network and files of
//! others where bubblewrap is installed.

use std::ffi::OsStr;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::files::failed;

/// The limits, and how they are set.
const SCRIPT: &str = include_str!("../../handout/sandbox.sh");

/// A folder with the `workbook` and the `target` of its builds.
pub struct Sandbox {
    pub folder: PathBuf,
}

impl Sandbox {
    /// The file with the output of the last program.
    pub fn output(&self) -> PathBuf {
        self.folder.join("output")
    }

    /// Runs a program with the limits of a kind, and returns its output.
    ///
    /// The error is a message to the student, and begins with `fails` if the program ends by
    /// itself.
    pub fn run(
        &self,
        kind: &str,
        program: impl IntoIterator<Item: AsRef<OsStr>>,
        fails: &str,
    ) -> Result<String, String> {
        let mut sandbox = Command::new("sh");
        sandbox.args(["-c", SCRIPT, "sh", kind]).arg(&self.folder);
        let ended = sandbox.args(program).stdin(Stdio::null()).status();
        let ended = ended.map_err(failed("sh".as_ref()))?;
        let said = fs::read(self.output()).map_err(failed(&self.output()))?;
        let said = String::from_utf8_lossy(&said);
        let why = match ended.code() {
            Some(0) => return Ok(said.into_owned()),
            Some(3) => "begun",
            Some(code) if code < 124 => fails,
            // By `timeout`, or by a signal.
            _ => "stopped by a limit of time, memory, processes or the size of a file",
        };
        // Before the answers, and without the messages of Cargo to programs.
        let said = said
            .split(exercise::MARK)
            .next()
            .unwrap_or_default()
            .lines();
        let said = said.filter(|line| !line.is_empty() && !line.starts_with('{'));
        Err([why].into_iter().chain(said).collect::<Vec<_>>().join("\n"))
    }
}
