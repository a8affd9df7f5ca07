//! `Server`: a private X server with a screen in a file.

use std::io::{BufRead, BufReader, Write};
use std::process::{Child, Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::{fs, io};

use tempfile::TempDir;

use super::{Picture, wait_for};

/// One server at a time, so that tests do not slow one another down.
static TURN: Mutex<()> = Mutex::new(());

/// A virtual screen. Its server ends when it is dropped.
pub struct Server {
    process: Child,
    /// The value of `DISPLAY`.
    pub name: String,
    folder: TempDir,
    _turn: MutexGuard<'static, ()>,
}

impl Server {
    /// A screen of this many pixels. On a machine without Xvfb or xdotool none, and a
    /// sentence on stderr.
    pub fn open([width, height]: [u32; 2]) -> Option<Self> {
        for (tool, argument) in [("Xvfb", "-help"), ("xdotool", "version")] {
            if let Err(error) = Command::new(tool).arg(argument).output() {
                // The output of `eprintln!` is shown for failing tests only.
                let _ = writeln!(io::stderr(), "not tested on a display: {tool}: {error}");
                return None;
            }
        }
        let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
        let folder = tempfile::tempdir().expect("a folder");
        // A server fails if another one takes the same number at the same moment.
        let (process, name) = wait_for("a server", || {
            let mut process = Command::new("Xvfb")
                .args(["-displayfd", "1", "-nolisten", "tcp", "-noreset"])
                .args(["-screen", "0", &format!("{width}x{height}x24"), "-fbdir"])
                .arg(folder.path())
                // Milliseconds until a key repeats: also on a busy machine xdotool has
                // released it before.
                .args(["-ardelay", "3000", "-arinterval", "20"])
                .stdout(Stdio::piped())
                .stderr(Stdio::null())
                .spawn()
                .expect("Xvfb starts");
            let mut number = String::new();
            let mut output = BufReader::new(process.stdout.take().expect("a pipe"));
            output.read_line(&mut number).expect("the display's number");
            if number.is_empty() {
                process.wait().expect("an end");
                return None;
            }
            Some((process, format!(":{}", number.trim())))
        });
        Some(Self {
            process,
            name,
            folder,
            _turn: turn,
        })
    }

    /// Runs xdotool and returns its output; none if it fails.
    pub fn xdotool(&self, line: &str) -> Option<String> {
        let output = Command::new("xdotool")
            .args(line.split_whitespace())
            .env("DISPLAY", &self.name)
            .output()
            .expect("xdotool runs");
        let text = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        output.status.success().then_some(text)
    }

    /// A part of the current screen, from the X window dump in the file: a header of
    /// big-endian numbers, a palette of twelve bytes per colour, and rows of pixels.
    pub fn look(&self, [left, top, width, height]: [u32; 4]) -> Picture {
        let dump = fs::read(self.folder.path().join("Xvfb_screen0")).expect("the screen");
        let number = |index: usize| {
            let bytes = dump[4 * index..][..4].try_into().expect("four bytes");
            u32::from_be_bytes(bytes) as usize
        };
        let (header, row_length, colors) = (number(0), number(12), number(19));
        let rows = &dump[header + 12 * colors..];
        Picture::from_fn(width, height, |x, y| {
            let (x, y) = ((left + x) as usize, (top + y) as usize);
            let bytes = rows[y * row_length + 4 * x..][..4].try_into();
            u32::from_ne_bytes(bytes.expect("a pixel")) & 0xFF_FFFF
        })
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
