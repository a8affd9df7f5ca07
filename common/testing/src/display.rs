//! `Display`: a private X server for a test, and the program that is shown on it. A
//! test sees the screen and uses keyboard and mouse, as a person does.
//!
//! The screen is read from the file in which Xvfb stores it. That is fast, so a test
//! can look again and again until the screen is as expected.

mod picture;
mod running_program;

use std::fs;
use std::io::{self, BufRead, BufReader, Write};
use std::os::unix::process::CommandExt;
use std::process::{Child, Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use tempfile::TempDir;

pub use picture::Picture;
pub use running_program::RunningProgram;

/// After this time a test stops waiting and fails.
const PATIENCE: Duration = Duration::from_mins(1);

/// One display at a time, so that tests do not slow one another down.
static TURN: Mutex<()> = Mutex::new(());

/// Waits until `find` returns a value.
///
/// # Panics
///
/// If it does not within a minute; the message contains `what`.
pub fn wait_for<T>(what: &str, mut find: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(found) = find() {
            return found;
        }
        assert!(start.elapsed() < PATIENCE, "waited in vain: {what}");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// A virtual screen. Its server ends when it is dropped.
pub struct Display {
    server: Child,
    name: String,
    folder: TempDir,
    _turn: MutexGuard<'static, ()>,
}

impl Display {
    /// A screen of this many pixels. On a machine without Xvfb or xdotool, none, and
    /// a sentence on stderr.
    ///
    /// # Panics
    ///
    /// If the tools are installed but do not work.
    #[must_use]
    pub fn open(width: u32, height: u32) -> Option<Self> {
        for (tool, argument) in [("Xvfb", "-help"), ("xdotool", "version")] {
            let found = Command::new(tool).arg(argument).output();
            if let Err(error) = found {
                // The output of `eprintln!` is shown for failing tests only.
                let line = format!("not tested on a display: {tool}: {error}\n");
                let _ = io::stderr().write_all(line.as_bytes());
                return None;
            }
        }
        let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
        let folder = tempfile::tempdir().expect("a folder");
        let mut server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-nolisten", "tcp", "-noreset"])
            .args(["-screen", "0", &format!("{width}x{height}x24"), "-fbdir"])
            .arg(folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb starts");
        let mut number = String::new();
        let mut output = BufReader::new(server.stdout.take().expect("a pipe"));
        output.read_line(&mut number).expect("the display's number");
        assert_ne!(number, "", "Xvfb serves no display");
        Some(Self {
            server,
            name: format!(":{}", number.trim()),
            folder,
            _turn: turn,
        })
    }

    /// Starts a program and waits for its window. The environment contains no
    /// variables that lead to another display or to a file dialog.
    ///
    /// # Panics
    ///
    /// If no window appears.
    pub fn start(&self, program: &mut Command) -> RunningProgram<'_> {
        let child = program
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .env_remove("XDG_RUNTIME_DIR")
            .env("DISPLAY", &self.name)
            .env("DBUS_SESSION_BUS_ADDRESS", "unix:path=/dev/null")
            .env("PATH", "")
            .env("TMPDIR", self.folder.path())
            // Processes that the program leaves behind are found by its process group.
            .process_group(0)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        RunningProgram::new(self, child)
    }

    /// Runs xdotool and returns what it prints.
    fn xdotool(&self, line: &str) -> String {
        let output = Command::new("xdotool")
            .args(line.split_whitespace())
            .env("DISPLAY", &self.name)
            .output()
            .expect("xdotool runs");
        String::from_utf8(output.stdout).expect("text")
    }

    /// Names of the temporary files that programs have left behind.
    ///
    /// # Panics
    ///
    /// If the folder cannot be read.
    #[must_use]
    pub fn temporary_files(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder.path()).expect("a folder");
        let names = entries.map(|entry| entry.expect("an entry").file_name());
        let names = names.map(|name| name.to_string_lossy().into_owned());
        // The file of the screen.
        names.filter(|name| name != "Xvfb_screen0").collect()
    }

    /// A part of the current screen, from the X window dump in the file: a header of
    /// big-endian numbers, a palette of twelve bytes per colour, and rows of pixels.
    fn look(&self, [left, top, width, height]: [u32; 4]) -> Picture {
        let dump = fs::read(self.folder.path().join("Xvfb_screen0")).expect("the screen");
        let number = |index: usize| {
            let bytes = dump[4 * index..][..4].try_into().expect("four bytes");
            u32::from_be_bytes(bytes) as usize
        };
        let (header, row_length, colors) = (number(0), number(12), number(19));
        let rows = &dump[header + 12 * colors..];
        let row = |y: u32| &rows[y as usize * row_length..];
        let pixel = |x: u32, y: u32| {
            let bytes = row(y)[4 * x as usize..][..4].try_into().expect("a pixel");
            u32::from_ne_bytes(bytes) & 0xFF_FFFF
        };
        Picture::from_fn(width, height, |x, y| pixel(left + x, top + y))
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}
