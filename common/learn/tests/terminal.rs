//! `cargo learn` on a terminal that a signal ends: what is typed afterwards is seen.
#![cfg(unix)]

use std::fs::{self, File};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{LocalModes, tcgetattr};

const WORKBOOK: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/terminal");

#[test]
fn a_signal_gives_the_terminal_back() {
    let exercises = Path::new(WORKBOOK).join("a01-image-display/exercises");
    let _ = fs::remove_dir_all(WORKBOOK);
    fs::create_dir_all(exercises.join("solutions")).unwrap();
    let list = "[[exercise]]\nname = \"own\"\ntitle = \"Own\"\nminutes = 5\nhints = [\"Look.\"]\n";
    fs::write(exercises.join("exercises.toml"), list).unwrap();
    fs::write(exercises.join("solutions/own.rs"), "").unwrap();

    let other_end = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
    grantpt(&other_end).unwrap();
    unlockpt(&other_end).unwrap();
    let name = ptsname(&other_end, Vec::new()).unwrap();
    let mut options = File::options();
    let terminal = options.read(true).write(true);
    let terminal = terminal.open(name.to_str().unwrap()).unwrap();
    let is_echoing = || {
        let modes = tcgetattr(&terminal).unwrap().local_modes;
        modes.contains(LocalModes::ECHO)
    };
    assert!(is_echoing());

    let mut learn = Command::new(env!("CARGO_BIN_EXE_learn"));
    learn.env("CARGO_MANIFEST_DIR", [WORKBOOK, "/common/learn"].concat());
    learn.stdin(terminal.try_clone().unwrap());
    learn.stdout(terminal.try_clone().unwrap());
    let mut learn = learn.spawn().unwrap();
    let end = Instant::now() + Duration::from_mins(1);
    while is_echoing() {
        assert!(Instant::now() < end, "no key is waited for");
        thread::sleep(Duration::from_millis(10));
    }
    kill_process(Pid::from_child(&learn), Signal::TERM).unwrap();
    let status = learn.wait().unwrap();
    assert_eq!(status.signal(), Some(Signal::TERM.as_raw()));
    assert!(is_echoing(), "nothing that is typed is seen");
}
