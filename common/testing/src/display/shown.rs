//! `Shown`: a program on a private display, and the actions of a person.

use std::fs;
use std::io::Read;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use tempfile::TempDir;

use super::server::Server;
use super::{Picture, wait_for};

/// A program and its window. It is ended when it is dropped.
pub struct Shown {
    child: Child,
    server: Server,
    /// The program's folder for temporary files.
    temporary: TempDir,
    window: String,
    /// Left, top, width and height of the window's inside.
    area: [u32; 4],
}

impl Shown {
    /// Starts a program in a folder with the arguments of a line, on a screen of this many
    /// pixels; waits for its window and gives it the keyboard. The environment contains no
    /// variables that lead to another display or to a file dialog. On a machine without
    /// Xvfb or xdotool none, and a sentence on stderr.
    #[must_use]
    pub fn start(program: &str, line: &str, folder: &Path, screen: [u32; 2]) -> Option<Self> {
        let server = Server::open(screen)?;
        let temporary = tempfile::tempdir().expect("a folder");
        let child = Command::new(program)
            .args(line.split_whitespace())
            .current_dir(folder)
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .env_remove("XDG_RUNTIME_DIR")
            .env("DISPLAY", &server.name)
            .env("DBUS_SESSION_BUS_ADDRESS", "unix:path=/dev/null")
            .env("PATH", "")
            .env("TMPDIR", temporary.path())
            // Processes that the program leaves behind are found by its process group.
            .process_group(0)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut shown = Self {
            child,
            server,
            temporary,
            window: String::new(),
            area: [0; 4],
        };
        shown.window = wait_for("a window", || {
            let end = shown.child.try_wait().expect("the program's state");
            assert!(end.is_none(), "no window: {}", shown.stderr());
            let found = shown.server.xdotool("search --onlyvisible --name .")?;
            found.lines().next().map(str::to_owned)
        });
        shown.area = wait_for("the place", || shown.place());
        shown.focus();
        Some(shown)
    }

    /// The window's place and size.
    fn place(&self) -> Option<[u32; 4]> {
        let line = format!("getwindowgeometry --shell {}", self.window);
        let output = self.server.xdotool(&line)?;
        let value = |name: &str| {
            let mut lines = output.lines();
            lines.find_map(|line| line.strip_prefix(name)?.strip_prefix('=')?.parse().ok())
        };
        Some([value("X")?, value("Y")?, value("WIDTH")?, value("HEIGHT")?])
    }

    /// Gives the keyboard to the window, and waits until the program has noticed.
    pub fn focus(&self) {
        let line = format!("windowfocus {}", self.window);
        wait_for("the keyboard", || {
            self.server.xdotool(&line);
            let focused = self.server.xdotool("getwindowfocus -f")?;
            (focused == self.window).then_some(())
        });
        self.settle();
    }

    /// The window's title.
    #[must_use]
    pub fn title(&self) -> String {
        let line = format!("getwindowname {}", self.window);
        self.server.xdotool(&line).unwrap_or_default()
    }

    /// Width and height of the window's inside.
    #[must_use]
    pub const fn size(&self) -> (u32, u32) {
        (self.area[2], self.area[3])
    }

    /// The current content of the window.
    #[must_use]
    pub fn look(&self) -> Picture {
        self.server.look(self.area)
    }

    /// Waits until the content of the window is as expected; `what` is for the message.
    pub fn wait_to_show(&self, what: &str, shows: impl Fn(&Picture) -> bool) {
        wait_for(what, || shows(&self.look()).then_some(()));
    }

    /// Presses and releases keys, such as `ctrl+s`, one after the other.
    pub fn press(&self, keys: &str) {
        self.act(&format!("key {keys}"));
    }

    /// Executes commands of xdotool, such as `keydown s` or `mousedown 1`; `WINDOW`
    /// stands for the window.
    pub fn act(&self, line: &str) {
        let line = line.replace("WINDOW", &self.window);
        // It fails, without effect, if a busy server does not answer.
        wait_for(&line, || self.server.xdotool(&line));
    }

    /// Moves the mouse to a pixel of the window's inside.
    pub fn point_at(&self, x: u32, y: u32) {
        let [left, top, ..] = self.area;
        self.act(&format!("mousemove {} {}", left + x, top + y));
    }

    /// Resizes the window, and moves it to the screen's upper left corner.
    pub fn resize(&mut self, width: u32, height: u32) {
        self.act(&format!(
            "windowmove WINDOW 0 0 windowsize WINDOW {width} {height}"
        ));
        self.area = [0, 0, width, height];
        wait_for("the size", || (self.place()? == self.area).then_some(()));
    }

    /// Waits until the program must have noticed changes that are not visible: the
    /// place of the mouse, and the window with the keyboard.
    ///
    /// Its first thread sleeps at least once in each turn of its loop, and at most a
    /// dozen times while a picture goes to the display.
    pub fn settle(&self) {
        let sleeps = || self.status("voluntary_ctxt_switches:");
        let start = sleeps();
        wait_for("turns of the loop", || {
            (sleeps() > start + 40).then_some(())
        });
    }

    /// A number in `/proc/PID/status`, such as `Threads:` or `VmRSS:` in KiB.
    #[must_use]
    pub fn status(&self, name: &str) -> u64 {
        let path = format!("/proc/{}/status", self.child.id());
        let status = fs::read_to_string(path).expect("a process");
        let line = status.lines().find_map(|line| line.strip_prefix(name));
        let number = line.and_then(|line| line.split_whitespace().next());
        number.and_then(|n| n.parse().ok()).expect("a number")
    }

    /// Processor time of the program so far, on all processors.
    #[must_use]
    pub fn time(&self) -> Duration {
        let fields = fields_of(&self.child.id().to_string()).expect("a process");
        // Linux counts hundredths of a second.
        let ticks = fields[11..13].iter().map(|ticks| ticks.parse::<u64>());
        Duration::from_millis(ticks.map(|ticks| 10 * ticks.expect("a number")).sum())
    }

    /// Waits for the program's end, which leaves no process and no temporary file, and
    /// returns its exit code and its output on stderr.
    #[must_use]
    pub fn wait_for_end(mut self) -> (Option<i32>, String) {
        let status = wait_for("the program's end", || {
            self.child.try_wait().expect("the program's state")
        });
        let group = self.child.id().to_string();
        for process in fs::read_dir("/proc").expect("the processes") {
            let process = process.expect("an entry").file_name();
            let process = process.to_string_lossy();
            // Others may end meanwhile.
            let fields = fields_of(&process);
            assert!(fields.is_none_or(|f| f[2] != group), "{process} is left");
        }
        let files = fs::read_dir(self.temporary.path()).expect("a folder");
        assert_eq!(files.count(), 0, "temporary files are left");
        (status.code(), self.stderr())
    }

    /// The output on stderr of the program, which must have ended.
    fn stderr(&mut self) -> String {
        let mut stderr = String::new();
        if let Some(mut pipe) = self.child.stderr.take() {
            pipe.read_to_string(&mut stderr).expect("text");
        }
        stderr
    }
}

impl Drop for Shown {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The fields in `/proc/PID/stat` behind the name, which may contain spaces: the first
/// is the state, the third the process group.
fn fields_of(process: &str) -> Option<Vec<String>> {
    let stat = fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    let fields = stat.rsplit(')').next()?.split_whitespace();
    Some(fields.map(str::to_owned).collect())
}
