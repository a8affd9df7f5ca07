//! `cargo learn` on a terminal, ended by a key or a signal: what is typed afterwards is seen, and neither a build nor a
//! check goes on.
#![cfg(unix)]

use std::fs::{File, TryLockError};
use std::io::{self, Read, Write};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command};
use std::time::{Duration, Instant};
use std::{fs, thread};

use rustix::process::{Pid, Signal, kill_process};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{LocalModes, tcgetattr};

const WORKBOOK: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/terminal");

const PACKAGE: &str = "[package]\nname = \"a01-image-display\"\nedition = \"2024\"\nbuild = \"build.rs\"\n\
    [[test]]\nname = \"exercises\"\npath = \"main.rs\"\nharness = false\n[workspace]";

const LIST: &str =
    "[[exercise]]\nname = \"own\"\ntitle = \"Own\"\nminutes = 5\nhints = [\"Look.\"]\n";

/// A program that locks a file as long as it runs.
const LOCKING: &str = "fn main() {
    let file = std::fs::File::create(\"lock\").unwrap();
    file.lock().unwrap();
    std::fs::write(\"begun\", \"\").unwrap();
    std::thread::sleep(std::time::Duration::from_secs(120));
}";

/// A `cargo learn` that ends with its test.
struct Learn(Child);

impl Drop for Learn {
    fn drop(&mut self) {
        let _ = self.0.kill();
    }
}

fn write(path: &str, text: &str) {
    let path = Path::new(WORKBOOK).join(path);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

fn wait_until(words: &str, is_so: &dyn Fn() -> bool) {
    let end = Instant::now() + Duration::from_mins(1);
    while !is_so() {
        assert!(Instant::now() < end, "{words}");
        thread::sleep(Duration::from_millis(10));
    }
}

/// The end of a pseudo terminal that a person uses, and that of a program.
fn pseudo_terminal() -> (File, File) {
    let persons = File::from(openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap());
    grantpt(&persons).unwrap();
    unlockpt(&persons).unwrap();
    let name = ptsname(&persons, Vec::new()).unwrap();
    let mut options = File::options();
    let programs = options.read(true).write(true).open(name.to_str().unwrap());
    (persons, programs.unwrap())
}

/// A `cargo learn` in the small workbook, on a terminal.
fn learn(terminal: &File) -> Command {
    let mut learn = Command::new(env!("CARGO_BIN_EXE_learn"));
    learn.env("CARGO_MANIFEST_DIR", [WORKBOOK, "/common/learn"].concat());
    learn
        .env("LEARN_SECONDS", "120")
        .env_remove("CARGO_TARGET_DIR");
    learn.current_dir(WORKBOOK);
    learn.stdin(terminal.try_clone().unwrap());
    learn.stdout(terminal.try_clone().unwrap());
    learn
}

/// What `cargo learn` shows until it waits for a key.
fn page_with(variable: &str, value: &str) -> String {
    let (mut person, terminal) = pseudo_terminal();
    let mut learn = learn(&terminal);
    learn
        .env("TERM", "xterm")
        .env_remove("NO_COLOR")
        .env(variable, value);
    let mut learn = Learn(learn.spawn().unwrap());
    let mut shown = Vec::new();
    while !String::from_utf8_lossy(&shown).contains("q quit") {
        let mut part = [0; 1024];
        let count = person.read(&mut part).unwrap();
        shown.extend(&part[..count]);
    }
    person.write_all(b"q").unwrap();
    learn.0.wait().unwrap();
    String::from_utf8(shown).unwrap()
}

#[test]
fn its_end_gives_the_terminal_back_and_leaves_no_program() {
    let _ = fs::remove_dir_all(WORKBOOK);
    write("Cargo.toml", PACKAGE);
    write("a01-image-display/exercises/exercises.toml", LIST);
    write("a01-image-display/exercises/solutions/own.rs", "");

    let (mut other_end, terminal) = pseudo_terminal();
    // A terminal that nobody reads takes no more words.
    let mut shown = other_end.try_clone().unwrap();
    thread::spawn(move || io::copy(&mut shown, &mut io::sink()));
    let is_echoing = || {
        let modes = tcgetattr(&terminal).unwrap().local_modes;
        modes.contains(LocalModes::ECHO)
    };
    let lock = Path::new(WORKBOOK).join("lock");

    write("build.rs", "fn main() {}");
    write("main.rs", "fn main() {}");
    let path = "a01-image-display/exercises/own.rs";
    let link = format!("in \u{1b}]8;;file://{WORKBOOK}/{path}\u{1b}\\{path}\u{1b}]8;;");
    for (variable, value, has_link) in [
        ("COLUMNS", "80", true),
        ("NO_COLOR", "1", false),
        ("TERM", "dumb", false),
    ] {
        let shown = page_with(variable, value);
        assert_eq!(
            shown.contains(&link),
            has_link,
            "{variable}={value}: {shown:?}"
        );
        assert!(
            has_link || shown.contains(&format!("in {path}")),
            "{shown:?}"
        );
    }

    // A build script is started by cargo, and a check by `learn`.
    for (build, check) in [(LOCKING, ""), ("fn main() {}", LOCKING)] {
        write("build.rs", build);
        write("main.rs", check);
        for end in [
            Some(Signal::TERM),
            Some(Signal::INT),
            Some(Signal::HUP),
            None,
        ] {
            let _ = fs::remove_file(Path::new(WORKBOOK).join("begun"));
            assert!(is_echoing());
            let mut learn = Learn(learn(&terminal).spawn().unwrap());
            wait_until("nothing is built", &|| {
                Path::new(WORKBOOK).join("begun").exists()
            });
            wait_until("no key is waited for", &|| !is_echoing());
            match end {
                Some(end) => kill_process(Pid::from_child(&learn.0), end).unwrap(),
                None => other_end.write_all(b"\x03").unwrap(),
            }
            let status = learn.0.wait().unwrap();
            assert_eq!(status.signal(), end.map(Signal::as_raw));
            assert!(is_echoing(), "{end:?}: nothing that is typed is seen");
            wait_until("a program goes on", &|| {
                let lock = File::open(&lock).unwrap().try_lock();
                !matches!(lock, Err(TryLockError::WouldBlock))
            });
        }
    }
}
