//! An evening with `cargo learn` and a small workbook: each step is answered soon, also after
//! a program that does not end.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::time::Duration;
use std::{env, fs, thread};

const WORKBOOK: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/workbook");
const PAGE: &str = include_str!("../../../book/src/a01-exercises.md");
const PACKAGE: &str = "[package]\nname = \"a01-image-display\"\nedition = \"2024\"\n\
    [[test]]\nname = \"exercises\"\npath = \"main.rs\"\nharness = false\n[workspace]";

/// A student's file, whose check ends with an exit code, or does not end.
const TO_DO: &str = "pub fn check() -> i32 { println!(\"to do\"); 3 }";
const RIGHT: &str = "pub fn check() -> i32 { 0 }";
const WRONG: &str = "pub fn check() -> i32 { 1 }";
const PANIC: &str = "pub fn check() -> i32 { panic!() }";
const BROKEN: &str = "pub fn check() -> i32 {";
const ENDLESS: &str = "pub fn check() -> i32 { println!(\"starts\"); loop {} }";

/// Exercise, the key that is typed or the text that is saved, and words of the answer.
const STEPS: [(&str, &str, &str); 22] = [
    ("set_pixel", "start", "to do"),
    ("set_pixel", "h", "Hint"),
    ("set_pixel", ENDLESS, "starts"),
    ("set_pixel", RIGHT, "set_pixel: done"),
    ("set_pixel", WRONG, "set_pixel: not yet"),
    ("set_pixel", "", "set_pixel: not yet"),
    ("set_pixel", RIGHT, "set_pixel: done"),
    ("set_pixel", "", "The diagonal, 10 minutes"),
    ("diagonal", PANIC, "diagonal: not yet"),
    ("diagonal", ENDLESS, "starts"),
    ("diagonal", "h", "Hint"),
    ("diagonal", BROKEN, "diagonal: does not compile"),
    ("diagonal", "deleted", "diagonal.rs is deleted"),
    ("diagonal", "", "to do"),
    ("diagonal", RIGHT, "diagonal: done"),
    ("diagonal", "l", "done   core  diagonal"),
    ("diagonal", "deleted", "diagonal.rs is deleted"),
    ("diagonal", "l", "         core  diagonal"),
    ("diagonal", "", "to do"),
    ("diagonal", RIGHT, "diagonal: done"),
    (
        "diagonal",
        "n",
        "minutes, in a01-image-display/exercises/ppm.rs",
    ),
    ("ppm", ENDLESS, "ppm: no end after 2 seconds"),
];

fn learn(arguments: &[&str]) -> Command {
    let mut learn = Command::new(env!("CARGO_BIN_EXE_learn"));
    learn.env("CARGO_MANIFEST_DIR", [WORKBOOK, "/common/learn"].concat());
    learn.args(arguments);
    learn
}

#[test]
fn each_step_is_answered() {
    let _ = fs::remove_dir_all(WORKBOOK);
    for folder in ["book/src", "a01-image-display/exercises/starters"] {
        fs::create_dir_all(Path::new(WORKBOOK).join(folder)).unwrap();
    }
    env::set_current_dir(WORKBOOK).unwrap();
    let file = |name: &str| format!("a01-image-display/exercises/{name}.rs");
    let modules = ["set_pixel", "diagonal", "ppm"].map(|name| {
        fs::write(file(&format!("starters/{name}")), TO_DO).unwrap();
        format!("#[cfg({name})] #[path = \"{}\"] mod yours;\n", file(name))
    });
    let main = "fn main() { std::process::exit(yours::check()) }";
    fs::write("main.rs", [&modules.concat(), main].concat()).unwrap();
    fs::write("Cargo.toml", PACKAGE).unwrap();
    fs::write("book/src/a01-exercises.md", PAGE).unwrap();

    let output = learn(&["hint", "diagnal"]).output().unwrap();
    assert!(String::from_utf8_lossy(&output.stderr).contains("diagonal"));
    if cfg!(target_os = "linux") {
        let full = fs::File::create("/dev/full").unwrap();
        let status = learn(&["list"]).stdout(full).status().unwrap();
        assert_eq!(status.code(), Some(1), "the list is lost");
    }

    let mut learn = learn(&[]);
    let learn = learn
        .env("LEARN_SECONDS", "2")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped());
    let learn = learn.stderr(Stdio::null());
    let mut learn = learn.spawn().unwrap();
    let (sender, printed) = channel();
    let lines = BufReader::new(learn.stdout.take().unwrap()).lines();
    thread::spawn(move || {
        lines
            .map_while(Result::ok)
            .try_for_each(|line| sender.send(line))
    });
    for (name, step, words) in STEPS {
        match step {
            "start" => {}
            "deleted" => fs::remove_file(file(name)).unwrap(),
            text if text.len() > 1 => fs::write(file(name), text).unwrap(),
            key => writeln!(learn.stdin.as_mut().unwrap(), "{key}").unwrap(),
        }
        let line = || printed.recv_timeout(Duration::from_secs(9));
        while !line().expect(step).contains(words) {}
    }
    drop(learn.stdin.take());
    assert!(learn.wait().unwrap().success(), "the end of the input");
}
