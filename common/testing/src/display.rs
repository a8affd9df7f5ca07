//! `Display`: a program with a window on a private X display, and the actions of a person.
//!
//! The window writes its state into a file; a test waits for the state that it expects, and
//! never for a time.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use std::{fs, thread};

use common::{Image, Transfer, fnv1a};
use tempfile::{NamedTempFile, TempDir, TempPath};

/// After this time a test stops waiting and fails.
const PATIENCE: Duration = Duration::from_mins(1);

/// Gives the keyboard to the window.
pub const FOCUS: (&str, &str) = ("windowfocus WINDOW", "is_active: true");

/// A program, its window and the display. Both processes end when it is dropped.
pub struct Display {
    server: Child,
    name: String,
    /// The program.
    pub program: Child,
    /// Its current folder, which is empty at the start.
    pub folder: TempDir,
    state: TempPath,
    window: String,
}

impl Display {
    /// Starts a program with the arguments of a line, on a screen of 1600x1300
    /// pixels, and gives its window the keyboard. The environment leads to no other display,
    /// to no file dialog and to no settings of a system. On a machine without Xvfb, xdotool or a
    /// library of windows none, and a sentence on stderr.
    #[must_use]
    pub fn start(program: &str, line: &str) -> Option<Self> {
        for (tool, argument) in [("Xvfb", "-help"), ("xdotool", "version")] {
            if let Err(error) = Command::new(tool).arg(argument).output() {
                // The output of `eprintln!` is shown for failing tests only.
                let _ = writeln!(io::stderr(), "not tested on a display: {tool}: {error}");
                return None;
            }
        }
        // A server fails if another one takes the same number at the same moment.
        let (server, name) = wait_for("a server", server);
        let folder = tempfile::tempdir().expect("a folder");
        let state = NamedTempFile::new().expect("a file").into_temp_path();
        let program = Command::new(program)
            .args(line.split_whitespace())
            .current_dir(&folder)
            .env_remove("WAYLAND_DISPLAY")
            .env("DISPLAY", &name)
            .env("DBUS_SESSION_BUS_ADDRESS", "unix:path=/dev/null")
            .env("PATH", "")
            .env("WINIT_X11_SCALE_FACTOR", "1")
            .env("WORKBOOK_WINDOW_STATE", &state)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut display = Self {
            server,
            name,
            program,
            folder,
            state,
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
            let reason = display.stderr();
            let lacks_library = ["not installed", "shared libraries"]
                .iter()
                .any(|words| reason.contains(words));
            assert!(lacks_library, "no window: {reason}");
            let _ = writeln!(io::stderr(), "not tested on a display: {reason}");
            return None;
        };
        display.window = window;
        display.play(&[FOCUS]);
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

    /// Executes actions, and waits after each one until the state of the window contains some
    /// texts, with ` & ` between them. An action is a command of xdotool, such as `key ctrl+s`,
    /// with `WINDOW` for the window, or `item`, a fraction of its width, and its text, for a click.
    pub fn play(&self, steps: &[(&str, &str)]) {
        for (action, texts) in steps {
            if let Some(item) = action.strip_prefix("item ") {
                self.click(item);
            } else {
                // It fails, without effect, if a busy server does not answer.
                wait_for(action, || self.xdotool(action));
            }
            wait_for(&format!("{texts} after {action}"), || {
                let state = self.state();
                let is_reached = texts.split(" & ").all(|text| state.contains(text));
                is_reached.then_some(())
            });
        }
    }

    /// Clicks on an item, as briefly as can be: no click is lost.
    fn click(&self, item: &str) {
        let (fraction, text) = item.split_once(' ').expect("a fraction and a text");
        let fraction: f64 = fraction.parse().expect("a fraction");
        let state = self.state();
        let (_, item) = state.split_once(&format!("{text:?} ")).expect(text);
        let (_, area) = item.split_once("Area {").expect(item);
        let numbers = area.split([' ', ',']).filter_map(|word| word.parse().ok());
        let [x, y, width, height] = numbers.take(4).collect::<Vec<f64>>()[..] else {
            panic!("{item}")
        };
        let [x, y] = [x + width * fraction, y + height / 2.0].map(|at| at as i32);
        let there = format!("mousemove --window WINDOW {x} {y}");
        self.play(&[
            (&there, &format!("at: [{x}, {y}]")),
            ("click 1", "left: false"),
        ]);
    }

    /// The current state of the window.
    #[must_use]
    pub fn state(&self) -> String {
        fs::read_to_string(&self.state).expect("the state")
    }

    /// Waits for the program's end, which must be one without an error.
    pub fn wait_for_end(mut self) {
        let status = wait_for("the program's end", || {
            self.program.try_wait().expect("a state")
        });
        assert_eq!((status.code(), self.stderr().as_str()), (Some(0), ""));
    }

    /// The messages of the program, which has ended.
    fn stderr(&mut self) -> String {
        let mut stderr = String::new();
        let pipe = self.program.stderr.as_mut().expect("a pipe");
        pipe.read_to_string(&mut stderr).expect("text");
        stderr
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        if thread::panicking() {
            eprintln!("the last state of the window: {}", self.state());
        }
        for process in [&mut self.program, &mut self.server] {
            let _ = process.kill();
            let _ = process.wait();
        }
    }
}

/// An X server and the value of `DISPLAY` for it.
fn server() -> Option<(Child, String)> {
    let mut server = Command::new("Xvfb")
        .args(["-displayfd", "1", "-nolisten", "tcp", "-noreset"])
        // Milliseconds until a key repeats: also on a busy machine xdotool has released it
        // before.
        .args(["-screen", "0", "1600x1300x24", "-ardelay", "3000"])
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

/// The state of a window that shows a finished picture, byte for byte.
#[must_use]
pub fn shown(picture: &Image) -> String {
    let hash = fnv1a(&picture.to_rgb8(Transfer::Linear));
    format!("picture: Some({hash})")
}
