//! `RunningProgram`: a program on a private display, and the actions of a person.

use std::fs;
use std::io::Read;
use std::process::Child;
use std::time::Duration;

use super::{Display, Picture, wait_for};

/// A program and its window. It is ended when it is dropped.
pub struct RunningProgram<'a> {
    display: &'a Display,
    child: Child,
    window: String,
    /// Left, top, width and height of the window's inside.
    area: [u32; 4],
}

impl<'a> RunningProgram<'a> {
    /// Waits for the window, and gives it the keyboard.
    pub(super) fn new(display: &'a Display, child: Child) -> Self {
        let mut shown = Self {
            display,
            child,
            window: String::new(),
            area: [0; 4],
        };
        shown.window = wait_for("a window", || {
            assert!(shown.is_running(), "no window: {}", shown.stderr());
            let found = display.xdotool("search --onlyvisible --name .");
            found.lines().next().map(str::to_owned)
        });
        shown.measure();
        shown.focus();
        shown.settle();
        shown
    }

    /// Measures the window's place and size.
    fn measure(&mut self) {
        let line = format!("getwindowgeometry --shell {}", self.window);
        let output = self.display.xdotool(&line);
        let value = |name: &str| {
            let mut lines = output.lines();
            let value = lines.find_map(|line| line.strip_prefix(name)?.strip_prefix('='));
            value.and_then(|value| value.parse().ok())
        };
        self.area = ["X", "Y", "WIDTH", "HEIGHT"].map(|name| value(name).expect("a window"));
    }

    /// Gives the keyboard to the window.
    pub fn focus(&self) {
        wait_for("the keyboard", || {
            self.display
                .xdotool(&format!("windowfocus {}", self.window));
            let focused = self.display.xdotool("getwindowfocus -f");
            (focused.trim() == self.window).then_some(())
        });
    }

    /// Takes the window from the screen, and with it the keyboard.
    pub fn hide(&self) {
        self.display
            .xdotool(&format!("windowunmap --sync {}", self.window));
    }

    /// Brings the window back to the screen.
    pub fn unhide(&self) {
        self.display
            .xdotool(&format!("windowmap --sync {}", self.window));
        self.focus();
    }

    /// The window's title.
    #[must_use]
    pub fn title(&self) -> String {
        let line = format!("getwindowname {}", self.window);
        self.display.xdotool(&line).trim().to_owned()
    }

    /// Width and height of the window's inside.
    #[must_use]
    pub const fn size(&self) -> (u32, u32) {
        (self.area[2], self.area[3])
    }

    /// The current content of the window.
    #[must_use]
    pub fn look(&self) -> Picture {
        self.display.look(self.area)
    }

    /// Waits until the content of the window is as expected.
    ///
    /// # Panics
    ///
    /// If it is not within a minute; the message contains `what`.
    pub fn wait_to_show(&self, what: &str, shows: impl Fn(&Picture) -> bool) -> Picture {
        wait_for(what, || Some(self.look()).filter(|picture| shows(picture)))
    }

    /// Presses and releases keys, such as `ctrl+s`, one after the other.
    pub fn press(&self, keys: &str) {
        self.display.xdotool(&format!("key {keys}"));
    }

    /// Uses keys and mouse with commands of xdotool: `keydown s`, `mousedown 1`.
    pub fn act(&self, line: &str) {
        self.display.xdotool(line);
    }

    /// Moves the mouse to a pixel of the window's inside.
    pub fn point_at(&self, x: u32, y: u32) {
        let [left, top, ..] = self.area;
        let (x, y) = (left + x, top + y);
        self.display.xdotool(&format!("mousemove {x} {y}"));
    }

    /// Waits until the program must have noticed changes that are not visible: the
    /// place of the mouse, and the window with the keyboard.
    ///
    /// Its first thread sleeps at least once in each turn of its loop, and at
    /// most a dozen times, while a picture goes to the display.
    pub fn settle(&self) {
        let sleeps = || self.status("voluntary_ctxt_switches:");
        let start = sleeps();
        wait_for("the program's attention", || {
            (sleeps() > start + 40).then_some(())
        });
    }

    /// Resizes the window, and moves it to the screen's upper left corner.
    pub fn resize(&mut self, width: u32, height: u32) {
        let window = self.window.clone();
        let line = format!("windowmove {window} 0 0 windowsize {window} {width} {height}");
        self.display.xdotool(&line);
        wait_for("the size", || {
            self.measure();
            (self.area == [0, 0, width, height]).then_some(())
        });
    }

    /// A file in `/proc` about the program.
    fn proc_file(&self, file: &str) -> String {
        let path = format!("/proc/{}/{file}", self.child.id());
        fs::read_to_string(path).expect("a process")
    }

    /// Memory that the program occupies, in KiB.
    ///
    /// # Panics
    ///
    /// If the program has ended.
    #[must_use]
    pub fn memory(&self) -> u64 {
        self.status("VmRSS:")
    }

    /// A number in the status of the program, or of its first thread.
    fn status(&self, name: &str) -> u64 {
        let status = self.proc_file("status");
        let line = status.lines().find_map(|line| line.strip_prefix(name));
        let figure = line.and_then(|line| line.split_whitespace().next());
        figure.and_then(|f| f.parse().ok()).expect("a figure")
    }

    /// Processor time of the program so far, on all processors.
    ///
    /// # Panics
    ///
    /// If the program has ended.
    #[must_use]
    pub fn time(&self) -> Duration {
        let stat = self.proc_file("stat");
        // The name in parentheses may contain spaces. Linux counts hundredths of a second.
        let fields = stat.rsplit(')').next().expect("fields");
        let ticks = fields.split_whitespace().skip(11).take(2);
        let ticks: u64 = ticks.map(|t| t.parse::<u64>().expect("a figure")).sum();
        Duration::from_millis(10 * ticks)
    }

    /// Number of threads.
    ///
    /// # Panics
    ///
    /// If the program has ended.
    #[must_use]
    pub fn threads(&self) -> usize {
        let path = format!("/proc/{}/task", self.child.id());
        fs::read_dir(path).expect("a process").count()
    }

    /// Waits for the program's end, and returns its exit code and its output on
    /// stderr.
    ///
    /// # Panics
    ///
    /// If the program does not end, or leaves another process behind.
    #[must_use]
    pub fn wait_for_end(mut self) -> (Option<i32>, String) {
        let status = wait_for("the program's end", || {
            self.child.try_wait().expect("the program's state")
        });
        let group = self.child.id().to_string();
        assert_eq!(group_members(&group), 0, "processes are left");
        (status.code(), self.stderr())
    }

    /// Whether the program is running.
    ///
    /// # Panics
    ///
    /// If its state cannot be read.
    #[must_use]
    pub fn is_running(&mut self) -> bool {
        let state = self.child.try_wait().expect("the program's state");
        state.is_none()
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

impl Drop for RunningProgram<'_> {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The number of processes in a group.
fn group_members(group: &str) -> usize {
    let processes = fs::read_dir("/proc").expect("the processes");
    let stats = processes.filter_map(|process| {
        // Others may end while they are counted.
        fs::read_to_string(process.ok()?.path().join("stat")).ok()
    });
    let group_of = |stat: &String| {
        let fields = stat.rsplit(')').next()?;
        fields.split_whitespace().nth(2).map(str::to_owned)
    };
    stats
        .filter_map(|stat| group_of(&stat))
        .filter(|g| g == group)
        .count()
}
