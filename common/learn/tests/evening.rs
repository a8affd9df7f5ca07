//! An evening with `cargo learn`, a small workbook and no terminal: each step is answered, also
//! after a program that does not end. `--nocapture` shows how soon.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::time::{Duration, Instant};
use std::{env, thread};

const WORKBOOK: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/workbook");
const PACKAGE: &str = "[package]\nname = \"a01-image-display\"\nedition = \"2024\"\n\
    [[test]]\nname = \"exercises\"\npath = \"main.rs\"\nharness = false\n[workspace]";

/// The starter, and files of a student, whose checks end with an exit code, or do not end.
const FILES: [(&str, &str); 6] = [
    ("starter", "println!(\"to do\"); 3"),
    ("right", "0"),
    ("wrong", "1"),
    ("panic", "panic!()"),
    ("broken", "{"),
    ("loop", "println!(\"starts\"); loop {}"),
];

/// The exercises in the order of their page.
const EXERCISES: [&str; 10] = [
    "set_pixel",
    "diagonal",
    "products",
    "angle",
    "reflected",
    "ppm",
    "srgb",
    "line",
    "thumbnail",
    "triangle_area",
];

/// The evening: exercises, and of each the steps: a file that is saved, the file's end, or the key that is
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

fn write(path: &str, text: &str) {
    fs::create_dir_all(Path::new(path).parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// The text of a file.
fn text(kind: &str) -> Option<String> {
    let (_, code) = FILES.iter().find(|(name, _)| *name == kind)?;
    Some(format!("pub fn check() -> i32 {{ {code} }}"))
}

/// The page that sets the exercises, of which the first ones are the core path.
fn page() -> String {
    let mut page = "# Exercises\n\n## Build along\n".to_owned();
    for name in EXERCISES {
        if name == "ppm" {
            page += "\n## Further exercises\n";
        }
        let section = format!(
            "\n### The {name}\n\n*10 minutes, in\n`a01-image-display/exercises/{name}.rs`*\n\n\
             Write it.\n\n```text\ncargo learn {name}\n```\n\n<details><summary>Hint</summary>\n\n\
             Look at it.\n\n</details>\n\n\
             Solution: `a01-image-display/exercises/solutions/{name}.rs`\n"
        );
        page += &section;
    }
    page
}

fn learn(arguments: &[&str]) -> Command {
    let mut learn = Command::new(env!("CARGO_BIN_EXE_learn"));
    learn.env("CARGO_MANIFEST_DIR", [WORKBOOK, "/common/learn"].concat());
    learn.args(arguments);
    learn
}

#[test]
fn each_step_is_answered() {
    let _ = fs::remove_dir_all(WORKBOOK);
    fs::create_dir(WORKBOOK).unwrap();
    env::set_current_dir(WORKBOOK).unwrap();
    let file = |name: &str| format!("a01-image-display/exercises/{name}.rs");
    let to_do = text("starter").unwrap();
    let names = BTreeSet::from(STEPS.map(|(name, _)| name));
    let modules = names.iter().map(|name| {
        write(&file(&format!("starters/{name}")), &to_do);
        format!("#[cfg({name})] #[path = \"{}\"] mod yours;\n", file(name))
    });
    let main = "fn main() { std::process::exit(yours::check()) }";
    write("main.rs", &(modules.collect::<String>() + main));
    write("Cargo.toml", PACKAGE);
    write("book/src/a01-exercises.md", &page());

    // An exercise that no page sets.
    let task = "//! Its title, 5 minutes\n//!\n//! Its task.\n";
    write(&file("starters/own"), task);
    let check = "a01-image-display/tests/exercises/own.rs";
    write(check, "//! Compares.\n//!\n//! Its hint.\n");
    let hint = learn(&["hint", "own"]).output().unwrap();
    assert_eq!(hint.stdout, b"Its title\n\nIts hint.\n\n");

    let output = learn(&["hint", "diagnal"]).output().unwrap();
    assert!(String::from_utf8_lossy(&output.stderr).contains("diagonal"));
    if cfg!(target_os = "linux") {
        let full = File::create("/dev/full").unwrap();
        let status = learn(&["list"]).stdout(full).status().unwrap();
        assert_eq!(status.code(), Some(1), "the list is lost");
    }

    let mut learn = learn(&[]);
    learn.env("LEARN_SECONDS", "2").stderr(Stdio::null());
    learn.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut learn = learn.spawn().unwrap();
    let mut typed = learn.stdin.take().unwrap();
    let (sender, printed) = channel();
    let mut lines = BufReader::new(learn.stdout.take().unwrap()).lines();
    thread::spawn(move || lines.try_for_each(|line| sender.send(line.unwrap())));
    for (name, steps) in STEPS {
        for step in steps.split('|') {
            let (asked, (act, words)) = (Instant::now(), step.split_once('>').unwrap());
            match text(act) {
                Some(text) => write(&file(name), &text),
                None if act == "delete" => fs::remove_file(file(name)).unwrap(),
                None if act == "start" => {}
                None => writeln!(typed, "{act}").unwrap(),
            }
            let line = || printed.recv_timeout(Duration::from_mins(1));
            while !line().expect(step).contains(words) {}
            println!("{:4} ms  {name}  {step}", asked.elapsed().as_millis());
        }
    }
    drop(typed);
    assert!(learn.wait().unwrap().success(), "the end of the input");
}
