//! An evening with `cargo learn`, a small workbook and no terminal: each step is answered, also
//! after a program that does not end. `--nocapture` shows how soon.

use std::collections::BTreeSet;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::time::{Duration, Instant};
use std::{env, fs, thread};

const WORKBOOK: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/workbook");
const PAGES: [&str; 2] = [
    include_str!("../../../book/src/a01-exercises.md"),
    include_str!("../../../book/src/a02-exercises.md"),
];
const PACKAGE: &str = "[package]\nname = \"a01-image-display\"\nedition = \"2024\"\n\
    [[test]]\nname = \"exercises\"\npath = \"main.rs\"\nharness = false\n[workspace]";

const TO_DO: &str = "pub fn check() -> i32 { println!(\"to do\"); 3 }";

/// A student's files, whose checks end with an exit code, or do not end.
const FILES: [(&str, &str); 5] = [
    ("right", "pub fn check() -> i32 { 0 }"),
    ("wrong", "pub fn check() -> i32 { 1 }"),
    ("panic", "pub fn check() -> i32 { panic!() }"),
    ("broken", "pub fn check() -> i32 {"),
    (
        "loop",
        "pub fn check() -> i32 { println!(\"starts\"); loop {} }",
    ),
];

/// Ten exercises, and of each the steps: a file that is saved, the file's end, or the key that is
/// typed, and words of the answer.
#[rustfmt::skip]
const STEPS: [(&str, &str); 14] = [
    ("set_pixel", "start>to do|h>Hint|loop>starts|right>: done|wrong>: not yet|>: not yet|right>: done"),
    ("set_pixel", ">The diagonal, 10 minutes"),
    ("diagonal", "panic>: not yet|loop>starts|h>Hint|broken>: does not compile|delete>l.rs is deleted"),
    ("diagonal", ">to do|right>: done|l>done   core  diagonal|delete>is deleted|l>         core  diagonal"),
    ("diagonal", ">to do|right>: done|n>exercises/products.rs"),
    ("products", "panic>: not yet|right>: done|>exercises/angle.rs"),
    ("angle", "broken>: does not compile|n>exercises/reflected.rs"),
    ("reflected", "right>: done|broken>: does not compile|right>: done|>exercises/angle.rs"),
    ("angle", "right>: done|>exercises/ppm.rs"),
    ("ppm", "panic>: not yet|n>exercises/srgb.rs"),
    ("srgb", "delete>srgb.rs is deleted|>to do|n>exercises/line.rs"),
    ("line", "loop>starts|n>exercises/thumbnail.rs"),
    ("thumbnail", "right>: done|>exercises/triangle_area.rs"),
    ("triangle_area", "loop>: no end after 2 seconds"),
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
    let folders = "book/src a01-image-display/exercises/starters a01-image-display/tests/exercises";
    for folder in folders.split(' ') {
        fs::create_dir_all(Path::new(WORKBOOK).join(folder)).unwrap();
    }
    env::set_current_dir(WORKBOOK).unwrap();
    let file = |name: &str| format!("a01-image-display/exercises/{name}.rs");
    let names: BTreeSet<_> = STEPS.iter().map(|(name, ..)| *name).collect();
    let modules = names.iter().map(|name| {
        fs::write(file(&format!("starters/{name}")), TO_DO).unwrap();
        format!("#[cfg({name})] #[path = \"{}\"] mod yours;\n", file(name))
    });
    let main = "fn main() { std::process::exit(yours::check()) }";
    fs::write("main.rs", modules.collect::<String>() + main).unwrap();
    fs::write("Cargo.toml", PACKAGE).unwrap();
    let page = PAGES.concat().replace("a02-math/", "a01-image-display/");
    fs::write("book/src/a01-exercises.md", page).unwrap();

    // An exercise that no page sets.
    fs::write(
        file("starters/own"),
        "//! Its title, 5 minutes\n//!\n//! Its task.\n",
    )
    .unwrap();
    let check = "a01-image-display/tests/exercises/own.rs";
    fs::write(check, "//! Compares.\n//!\n//! Its hint.\n").unwrap();
    let hint = learn(&["hint", "own"]).output().unwrap();
    assert_eq!(hint.stdout, b"Its title\n\nIts hint.\n\n");

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
    let steps = STEPS
        .iter()
        .flat_map(|(name, steps)| steps.split('|').map(move |it| (name, it)));
    for (name, step) in steps {
        let (asked, (act, words)) = (Instant::now(), step.split_once('>').unwrap());
        match FILES.iter().find(|(kind, _)| *kind == act) {
            Some((_, text)) => fs::write(file(name), text).unwrap(),
            None if act == "delete" => fs::remove_file(file(name)).unwrap(),
            None if act == "start" => {}
            None => writeln!(learn.stdin.as_mut().unwrap(), "{act}").unwrap(),
        }
        let line = || printed.recv_timeout(Duration::from_mins(1));
        while !line().expect(step).contains(words) {}
        println!("{:4} ms  {name}  {step}", asked.elapsed().as_millis());
    }
    drop(learn.stdin.take());
    assert!(learn.wait().unwrap().success(), "the end of the input");
}
