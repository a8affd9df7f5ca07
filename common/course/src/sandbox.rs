//! `Sandbox`: runs programs that nobody trusts, with limits, and without network and files of
//! others where bubblewrap is installed.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};

use judge::answers::{BEGUN, MARK};
use learn::files::{self, with_path};

/// The limits, and how they are set.
const SCRIPT: &str = include_str!("../handout/sandbox.sh");

/// Where a program sees the folder, if bubblewrap runs.
const INSIDE: &str = "/course";

/// What may run: the first build of the workbook, that of a student's file, its program, or one that draws a
/// picture within some seconds.
#[derive(Clone, Copy)]
pub enum Limits {
    All,
    Build,
    Check,
    Picture { seconds: u32 },
}

/// Where it runs.
#[derive(Clone, Copy)]
pub enum Place {
    Workbook,
    /// The folder of a student's own program.
    Program,
}

/// How a program ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    Success,
    /// By the exit code of a program whose code is incomplete.
    Begun,
    Failure,
    Limit(Limit),
}

/// A limit by which a program ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    Time,
    ProcessorTime,
    FileSize,
    MemoryOrDepth,
    /// The exit code does not tell which.
    Unknown,
}

impl Limit {
    pub fn words(self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::ProcessorTime => "processor time",
            Self::FileSize => "the size of a file",
            Self::MemoryOrDepth => "memory, or of the depth of calls",
            Self::Unknown => "time, memory, processes or the size of a file",
        }
    }
}

/// A program that has ended, and its output.
#[derive(Debug)]
pub struct Ended {
    pub end: End,
    pub output: String,
}

/// A folder with the `workbook`, a student's own `program`, its `pictures`, and the `target` of builds. One program runs in it at a time.
pub struct Sandbox {
    pub folder: PathBuf,
}

impl Sandbox {
    /// Runs a program with limits. An error is a fault of the sandbox, not of the program.
    pub fn run(
        &self,
        limits: Limits,
        place: Place,
        program: impl IntoIterator<Item: AsRef<OsStr>>,
    ) -> Result<Ended, String> {
        let mut sandbox = Command::new("sh");
        let limits = match limits {
            Limits::All => "all",
            Limits::Build => "build",
            Limits::Check => "check",
            Limits::Picture { seconds } => {
                sandbox.env("PICTURE_SECONDS", seconds.to_string());
                "picture"
            }
        };
        let place = match place {
            Place::Workbook => "workbook",
            Place::Program => "program",
        };
        sandbox
            .args(["-c", SCRIPT, "sh", limits, place])
            .arg(&self.folder)
            .args(program)
            .stdin(Stdio::null());
        let status = sandbox.status().map_err(with_path("sh".as_ref()))?;
        let output = self.folder.join("output");
        let output = fs::read(&output).map_err(with_path(&output))?;
        let output = String::from_utf8_lossy(&output).into_owned();
        if output.starts_with("bwrap: ") {
            return Err(output);
        }
        Ok(Ended {
            end: end(exit_code(status)),
            output,
        })
    }

    /// What the student reads about a program that does not succeed: `fails` if it ends by itself,
    /// and what it says before its answers, without the messages of Cargo to programs.
    pub fn words(&self, ended: &Ended, fails: &str) -> String {
        let mut words = match ended.end {
            End::Limit(_) if ended.output.contains("has overflowed its stack") => {
                "the stack overflows, probably by a recursion without end".to_owned()
            }
            End::Success | End::Failure => fails.to_owned(),
            End::Begun => "begun".to_owned(),
            End::Limit(limit) => format!("stopped by the limit of {}", limit.words()),
        };
        let (said, _) = ended.output.split_once(MARK).unwrap_or((&ended.output, ""));
        for line in self.without_place(said).lines() {
            if !line.is_empty() && !line.starts_with('{') {
                words += "\n";
                words += line;
            }
        }
        words
    }

    /// A text that names no folder of the grader.
    pub fn without_place(&self, text: &str) -> String {
        let folder = self.folder.display().to_string();
        let lecturers = files::workspace().display().to_string();
        let mut text = text.to_owned();
        for place in [&*folder, INSIDE] {
            for part in ["/workbook/", "/program/", "/target/"] {
                text = text.replace(&[place, part].concat(), "");
            }
        }
        text.replace(&[&lecturers, "/"].concat(), "")
    }
}

/// An empty folder, in which nothing of an earlier program is.
pub fn empty(folder: &Path) -> Result<(), String> {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(with_path(folder))?;
    }
    fs::create_dir_all(folder).map_err(with_path(folder))
}

/// The exit code as a shell gives it: of a signal, 128 more than its number.
#[cfg(unix)]
fn exit_code(status: ExitStatus) -> Option<i32> {
    use std::os::unix::process::ExitStatusExt;

    let of_signal = status.signal().map(|signal| 128 + signal);
    status.code().or(of_signal)
}

#[cfg(not(unix))]
fn exit_code(status: ExitStatus) -> Option<i32> {
    status.code()
}

/// How a program ends, by the exit code of a shell: 128 and more are signals.
fn end(code: Option<i32>) -> End {
    match code {
        Some(0) => End::Success,
        Some(code) if code == i32::from(BEGUN) => End::Begun,
        // `timeout` kills, and so does the system, a process that has used its processor time.
        Some(124 | 137) => End::Limit(Limit::Time),
        Some(152) => End::Limit(Limit::ProcessorTime),
        Some(153) => End::Limit(Limit::FileSize),
        // Rust aborts without memory, and where the stack overflows.
        Some(134) => End::Limit(Limit::MemoryOrDepth),
        Some(code) if code < 124 => End::Failure,
        _ => End::Limit(Limit::Unknown),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn students_read_no_folder_of_the_grader() {
        let folder = files::workspace().join("target/grading");
        let workspace = files::workspace().display().to_string();
        let output = format!(
            "cannot write {}/workbook/out/a.png\n\
             {INSIDE}/workbook/a01/exercises/a.rs:1\n\
             {INSIDE}/target/debug/a\n\
             {INSIDE}/program/src/a.rs\n\
             {workspace}/book/src/a.md\n\
             {}the answers",
            folder.display(),
            MARK,
        );
        let ended = Ended {
            end: end(Some(1)),
            output,
        };
        let words = Sandbox { folder }.words(&ended, "not yet");
        let without = "not yet\ncannot write out/a.png\na01/exercises/a.rs:1\ndebug/a\nsrc/a.rs\nbook/src/a.md";
        assert_eq!(words, without);
    }
}
