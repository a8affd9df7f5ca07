//! `Display`: a program with a window on a private X display, and the actions of a person.
//!
//! A test sees the window's title and what the program prints. It waits for these, and never for a
//! time.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Write};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};
use std::{fs, thread};

use tempfile::TempDir;

/// After this time a test stops waiting and fails.
const PATIENCE: Duration = Duration::from_mins(1);

/// A program, its window and the display. Both processes end when it is dropped.
pub struct Display {
    server: Child,
    name: String,
    /// The program.
    pub program: Child,
    /// Its current folder, which is empty at the start, but for what it prints.
    pub folder: TempDir,
    window: String,
}

impl Display {
    /// Starts a program with the arguments of a line, on a screen of 1600x1300
    /// pixels, and gives its window the keyboard. On a machine without Xvfb, xdotool, setxkbmap or a library of
    /// windows none, and a sentence on stderr.
    #[must_use]
    pub fn start(program: &str, line: &str) -> Option<Self> {
        Self::start_with_keyboard("us", program, line)
    }

    /// The same with the letters of a country on the keyboard.
    #[must_use]
    pub fn start_with_keyboard(country: &str, program: &str, line: &str) -> Option<Self> {
        if !has_tools() {
            return None;
        }
        // A server fails if another one takes the same number at the same moment.
        let (server, name) = wait_for("a server", || server(24));
        let mut letters = Command::new("setxkbmap");
        let letters = letters.arg(country).env("DISPLAY", &name).status();
        letters.expect("setxkbmap runs");
        let folder = tempfile::tempdir().expect("a folder");
        let file = |name| File::create(folder.path().join(name)).expect("a file");
        let program = command(program, line, &folder, &name)
            .stdin(Stdio::null())
            .stdout(file("stdout"))
            .stderr(file("stderr"))
            .spawn()
            .expect("the program starts");
        let mut display = Self {
            server,
            name,
            program,
            folder,
            window: String::new(),
        };
        let window = wait_for("a window", || {
            let found = display.xdotool("search --onlyvisible --name .");
            let window = found.and_then(|found| found.lines().next().map(str::to_owned));
            // Without a window the program writes a picture, and ends.
            let has_ended = matches!(display.program.try_wait(), Ok(Some(_)));
            (window.is_some() || has_ended).then_some(window)
        });
        let Some(window) = window else {
            let reason = display.printed("stderr");
            assert!(reason.contains("failed to load"), "no window: {reason}");
            let _ = writeln!(io::stderr(), "not tested on a display: {reason}");
            return None;
        };
        display.window = window;
        // Before it has the keyboard, the program looks for clicks only 10 times in a second.
        display.act("windowfocus --sync WINDOW sleep 0.3");
        Some(display)
    }

    /// Runs xdotool and returns its output; none if it fails.
    fn xdotool(&self, line: &str) -> Option<String> {
        let line = line.replace("WINDOW", &self.window);
        let mut command = Command::new("xdotool");
        let command = command.args(line.split_whitespace());
        let output = command.env("DISPLAY", &self.name).output();
        let output = output.expect("xdotool runs");
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        output.status.success().then_some(text)
    }

    /// Executes a command of xdotool, such as `key s`, with `WINDOW` for the window.
    pub fn act(&self, action: &str) {
        // It fails, without effect, if a busy server does not answer.
        wait_for(action, || self.xdotool(action));
    }

    /// Clicks on a place of the window until the program has printed this text: on a busy machine a click
    /// can be over before the program looks for it.
    pub fn click_until(&self, x: i32, y: i32, text: &str) {
        self.act(&format!("mousemove --window WINDOW {x} {y}"));
        wait_for(text, || {
            self.act("mousedown 1 sleep 0.1 mouseup 1 sleep 0.3");
            self.printed("stdout").contains(text).then_some(())
        });
    }

    /// Waits until the title of the window contains this, and the picture is finished.
    pub fn wait_for_picture(&self, name: &str) {
        wait_for(name, || {
            let title = self.xdotool("getwindowname WINDOW")?;
            (title.contains(name) && !title.contains("elapsed")).then_some(())
        });
    }

    /// Waits until the program has printed this text.
    pub fn wait_for_line(&self, text: &str) {
        wait_for(text, || self.printed("stdout").contains(text).then_some(()));
    }

    /// What the program has printed until now, on `stdout` or `stderr`.
    #[must_use]
    pub fn printed(&self, stream: &str) -> String {
        fs::read_to_string(self.folder.path().join(stream)).expect("text")
    }

    /// Waits for the program's end, which must be one without an error.
    pub fn wait_for_end(mut self) {
        let status = wait_for("the program's end", || {
            self.program.try_wait().expect("a state")
        });
        assert_eq!((status.code(), &*self.printed("stderr")), (Some(0), ""));
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        for process in [&mut self.program, &mut self.server] {
            let _ = process.kill();
            let _ = process.wait();
        }
    }
}

/// Runs a program on a screen whose pixels have `depth` bits, on which it opens no window, until it ends; none on
/// a machine without the tools. The folder is its current one.
#[must_use]
pub fn run_at_depth(depth: u32, program: &str, line: &str) -> Option<(Output, TempDir)> {
    if !has_tools() {
        return None;
    }
    let (mut server, name) = wait_for("a server", || server(depth));
    let folder = tempfile::tempdir().expect("a folder");
    let output = command(program, line, &folder, &name).output();
    let _ = server.kill();
    let _ = server.wait();
    Some((output.expect("the program runs"), folder))
}

/// Whether Xvfb, xdotool and setxkbmap are there; otherwise a sentence on stderr.
fn has_tools() -> bool {
    let tools = [
        ("Xvfb", "-help"),
        ("xdotool", "version"),
        ("setxkbmap", "-version"),
    ];
    for (tool, argument) in tools {
        if let Err(error) = Command::new(tool).arg(argument).output() {
            // The output of `eprintln!` is shown for failing tests only.
            let _ = writeln!(io::stderr(), "not tested on a display: {tool}: {error}");
            return false;
        }
    }
    true
}

/// A program on a display. The environment leads to no other display, to no file dialog, and to an
/// input method that does not run.
fn command(program: &str, line: &str, folder: &TempDir, display: &str) -> Command {
    let mut command = Command::new(program);
    command
        .args(line.split_whitespace())
        .current_dir(folder)
        .env_remove("WAYLAND_DISPLAY")
        .env("DISPLAY", display)
        .env("DBUS_SESSION_BUS_ADDRESS", "unix:path=/dev/null")
        .env("XMODIFIERS", "@im=none")
        .env("PATH", "");
    command
}

/// An X server and the value of `DISPLAY` for it.
fn server(depth: u32) -> Option<(Child, String)> {
    let mut server = Command::new("Xvfb")
        .args(["-displayfd", "1", "-nolisten", "tcp", "-noreset"])
        // Milliseconds until a key repeats: also on a busy machine xdotool has released it
        // before.
        .args(["-screen", "0", &format!("1600x1300x{depth}")])
        .args(["-ardelay", "3000"])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("Xvfb starts");
    let mut number = String::new();
    let mut output = BufReader::new(server.stdout.take().expect("a pipe"));
    output.read_line(&mut number).expect("the display's number");
    if number.is_empty() {
        server.wait().expect("an end");
        return None;
    }
    Some((server, format!(":{}", number.trim())))
}

/// Waits until `find` returns a value; fails after a minute, with `what` in the message.
pub fn wait_for<T>(what: &str, mut find: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(found) = find() {
            return found;
        }
        assert!(start.elapsed() < PATIENCE, "waited in vain: {what}");
        thread::sleep(Duration::from_millis(5));
    }
}
