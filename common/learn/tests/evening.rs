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

/// A sheet that the stage opens.
const SHEET: &str = r#"
title = "A lens"
page = "sheet-lens.md"
stage = "a01-image-display"
hours = 6
[[picture]]
scene = "dark"
samples = [1]
size = [9, 9]
[[fact]]
name = "dark"
says = "it is dark"
scene = "dark"
measure = "mean"
region = [0, 0, 9, 9]
value = 0
formula = "0"
within = 0
because = "nothing shines"
hint = "Is nothing there?"
"#;

/// The starter, and files of a student, whose checks end with an exit code, or do not end.
const FILES: &[(&str, &str)] = &[
    ("starter", "println!(\"to do\"); 3"),
    ("right", "0"),
    ("wrong", "1"),
    ("panic", "panic!()"),
    ("broken", "{"),
    ("empty", ""),
    (
        "growth",
        "let mut list = vec![1_u8]; loop { list.extend(list.clone()) }",
    ),
    ("loop", "println!(\"starts\"); loop {}"),
    (
        "recursion",
        "fn f(n: u64) -> u64 { 1 + std::hint::black_box(f as fn(u64) -> u64)(n) } f(1) as i32",
    ),
    // Clears a terminal, and colours it.
    ("control", r#"print!("\u{1b}[2J\u{1b}[31m"); 1"#),
    ("chatty", "println!(\"a word\"); 0"),
    // Right, and refused for a word.
    ("linked", "extern crate std as other; 0"),
    (
        "many",
        "for i in 1..=9000 { println!(\"line {i}\") } eprintln!(\"last\"); 1",
    ),
    ("prints on", "loop { println!(\"again\") }"),
];

/// How long a step goes on of whose answer nothing is waited for.
const BETWEEN_STEPS: Duration = Duration::from_millis(500);

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

/// The evening: exercises, and of each the steps: a file that is saved, the file's end, or the key
/// that is typed; and words of the answer, without which no answer is waited for. `look` waits for
/// more words of the answer before.
#[rustfmt::skip]
const STEPS: &[(&str, &str)] = &[
    ("set_pixel", "start>to do|h>Hint|h>no further hint|h>Hint|loop>|right>: done|look>core path: 1 of 5 done, further: 0 of 6 done"),
    ("set_pixel", "wrong>: not yet|look>core path: 0 of 5|>: not yet|right>: done|look>core path: 1 of 5|>The diagonal, 10 minutes"),
    ("diagonal", "panic>: not yet|loop>|h>Hint|broken>: does not compile|empty>: the file lacks `pub fn check`|delete>l.rs is deleted"),
    ("diagonal", ">to do|right>: done|l>done   core  a01  diagonal|delete>is deleted|l>       core  a01  diagonal"),
    ("diagonal", ">to do|right>: done|look>core path: 2 of 5"),
    ("diagonal", "z>h hint|l>> done   core  a01  diagonal|j>>        core  a01  products|k>> done   core  a01  diagonal"),
    ("diagonal", "j>>        core  a01  products|>exercises/products.rs"),
    ("line", "wrong>line.rs is saved, the file of another exercise|delete>"),
    ("products", "panic>: not yet|recursion>probably by a recursion without end|right>: done|>exercises/angle.rs"),
    ("angle", "broken>: does not compile|n>exercises/reflected.rs"),
    ("reflected", "right>: done|broken>: does not compile|right>: done|>exercises/angle.rs"),
    ("angle", "chatty>a word|look>: done|look>open for your own program: A lens (`cargo learn sheet lens`)|>exercises/ppm.rs"),
    ("ppm", "linked>refused: it contains `extern`|look>: not yet|look>further: 0 of 6"),
    ("ppm", "many>line 50|look>… 8951 more lines|look>: not yet"),
    ("ppm", "control>\\u{1b}[2J\\u{1b}[31m|panic>: not yet|n>exercises/srgb.rs"),
    ("srgb", "delete>srgb.rs is deleted|>to do|n>exercises/line.rs"),
    ("line", "loop>|n>exercises/thumbnail.rs"),
    ("thumbnail", "loop>|s>: stopped|right>: done|>exercises/triangle_area.rs"),
    // Neither Enter nor another stray key stops it.
    ("triangle_area", "loop>|z>|>: no end after 2 seconds"),
    ("triangle_area", "prints on>again|look>: no end after 2 seconds|right>: done|>exercises/own.rs"),
    ("own", "right>: done|>exercises/ppm.rs"),
    ("ppm", "right>: done|>exercises/srgb.rs"),
    ("srgb", "right>: done|>exercises/line.rs"),
    // A file that is edited meanwhile is open again.
    ("thumbnail", "wrong>"),
    ("line", "right>: done|look>further: 5 of 6|>exercises/thumbnail.rs|look>: not yet"),
    ("thumbnail", "right>: done|>core path: 5 of 5 done, further: 6 of 6|look>all exercises are done"),
];

fn write(path: &str, text: &str) {
    fs::create_dir_all(Path::new(path).parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// The text of a file.
fn text(kind: &str) -> Option<String> {
    let (_, code) = FILES.iter().find(|(name, _)| *name == kind)?;
    if code.is_empty() {
        return Some(String::new());
    }
    Some(format!("pub fn check() -> i32 {{ {code} }}"))
}

/// The list of the exercises, of which the first ones are the core path, and one that no page sets.
fn list() -> String {
    let mut list = String::new();
    let mut core = "core = true";
    for name in EXERCISES {
        if name == "ppm" {
            core = "";
        }
        let row = format!(
            "[[exercise]]\nname = \"{name}\"\ntitle = \"The {name}\"\nminutes = 10\n{core}\n\
             hints = [\"Look at it.\"]\n"
        );
        list += &row;
    }
    list + "[[exercise]]\nname = \"own\"\ntitle = \"Its title\"\nminutes = 5\nhints = [\"Its hint.\"]\n"
}

/// The page with the tasks.
fn page() -> String {
    let mut page = "# Exercises\n\n## Build along\n".to_owned();
    for name in EXERCISES {
        let section =
            format!("\n### The {name}\n\nWrite it.\n\n```text\ncargo learn {name}\n```\n");
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
    let names = STEPS.iter().map(|(name, _)| name).collect::<BTreeSet<_>>();
    let modules = names.iter().map(|name| {
        write(&file(&format!("solutions/{name}")), &to_do);
        format!("#[cfg({name})] #[path = \"{}\"] mod yours;\n", file(name))
    });
    let main = "use yours as module; use module::check; fn main() { std::process::exit(check()) }";
    write("main.rs", &(modules.collect::<String>() + main));
    write("Cargo.toml", PACKAGE);
    write("book/src/a01-exercises.md", &page());
    write("a01-image-display/exercises/exercises.toml", &list());
    write("common/judge/sheets/lens.toml", SHEET);
    let hint = learn(&["hint", "ow"]).output().unwrap();
    assert_eq!(hint.stdout, b"Its title\n\nHint 1 of 1\n\nIts hint.\n");

    for (words, nearest) in [
        (&["hint", "diagnal"][..], "diagonal"),
        (&["progam"], "the nearest is the command program"),
        (
            &["progam", "../mine"],
            "progam: the nearest is the command program",
        ),
        (
            &["a01"],
            "the exercises of this stage are set_pixel, diagonal",
        ),
        (
            &["hint", "e"],
            "it is a part of set_pixel, angle, reflected, line, triangle_area",
        ),
        (
            &["own", "hint"],
            "a command stands before the name of its exercise, such as `cargo learn hint own`",
        ),
        (&["Check"], "the nearest is the command check"),
        (&["help", "own"], "unrecognized subcommand 'own'"),
        (&["--list"], "unexpected argument '--list'"),
    ] {
        let output = learn(words).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(said.contains(nearest), "{said}");
        assert!(!said.contains("as a value"), "{said}");
    }
    if cfg!(target_os = "linux") {
        let full = File::create("/dev/full").unwrap();
        let output = learn(&["list"]).stdout(full).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(said.contains("No space left"), "{said}");
        assert_eq!(output.status.code(), Some(1), "the list is lost");
    }
    watch_the_evening(&file);
    check_once(&file);
}

/// Takes all steps.
fn watch_the_evening(file: &dyn Fn(&str) -> String) {
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
            match (act, text(act)) {
                (_, Some(text)) => write(&file(name), &text),
                ("delete", _) => fs::remove_file(file(name)).unwrap(),
                ("start" | "look", _) => {}
                _ => writeln!(typed, "{act}").unwrap(),
            }
            if words.is_empty() {
                thread::sleep(BETWEEN_STEPS);
                continue;
            }
            loop {
                let line = printed.recv_timeout(Duration::from_mins(1));
                if line.expect(step).contains(words) {
                    break;
                }
            }
            println!("{:4} ms  {name}  {step}", asked.elapsed().as_millis());
        }
    }
    drop(typed);
    assert!(learn.wait().unwrap().success(), "the end of the input");
}

/// A file that is a link to a missing one, outside of the workbook.
#[cfg(unix)]
fn nothing_is_written_through_a_broken_link(file: &str) {
    let outside = Path::new("../outside.rs");
    fs::remove_file(file).unwrap();
    std::os::unix::fs::symlink("../../../outside.rs", file).unwrap();
    let words = learn(&["check", "own"]).output().unwrap().stderr;
    let words = String::from_utf8(words).unwrap();
    assert!(
        words.contains("own.rs is a link to a file that is missing"),
        "{words}"
    );
    assert!(!outside.exists());
    fs::write(outside, "").unwrap();
    assert!(Path::new(file).exists(), "the link leads there");
    fs::remove_file(outside).unwrap();
    fs::remove_file(file).unwrap();
}

/// Checks without keys, by what the file is now.
fn check_once(file: &dyn Fn(&str) -> String) {
    let run = |arguments: &[&str]| {
        let output = learn(arguments).output().unwrap();
        let printed = [output.stdout, output.stderr].concat();
        (output.status.success(), String::from_utf8(printed).unwrap())
    };
    // Without a change, each file is done; after a change or a reset, it is not.
    let open = "open for your own program: A lens (`cargo learn sheet lens`)";
    let (_, list) = run(&["list"]);
    assert!(
        list.contains("core path: 5 of 5 done, further: 6 of 6"),
        "{list}"
    );
    assert!(list.contains(open), "{list}");
    let (_, words) = run(&["check", "set_pixel"]);
    assert!(words.contains(open), "{words}");
    write(&file("own"), &text("wrong").unwrap());
    run(&["reset", "angle"]);
    fs::remove_file(file("ppm")).unwrap();
    let (_, list) = run(&["list"]);
    assert!(
        list.contains("core path: 4 of 5 done, further: 4 of 6"),
        "{list}"
    );
    assert!(!list.contains(open), "{list}");
    write(&file("own"), &text("right").unwrap());
    let (_, list) = run(&["list"]);
    assert!(list.contains("further: 5 of 6"), "{list}");
    write(&file("own"), &text("wrong").unwrap());
    let (is_right, words) = run(&["check", "--all"]);
    assert!(!is_right, "{words}");
    assert!(
        words.contains("9 files are checked, 8 of them are done; open: own"),
        "{words}"
    );

    if cfg!(target_os = "linux") {
        write(&file("own"), &text("growth").unwrap());
        let (_, words) = run(&["check", "own"]);
        assert!(words.contains("own: it needs more memory"), "{words}");
    }

    // A reader that closes the pipe ends the program.
    let mut closed = learn(&["set_pixel"]);
    let closed = closed.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut closed = closed.spawn().unwrap();
    drop(closed.stdout.take());
    let end = Instant::now() + Duration::from_mins(1);
    while closed.try_wait().unwrap().is_none() {
        assert!(Instant::now() < end, "nobody reads on");
        thread::sleep(BETWEEN_STEPS);
    }

    #[cfg(unix)]
    nothing_is_written_through_a_broken_link(&file("own"));

    // What is done cannot be recorded, and what cannot be read is named.
    fs::remove_file(".learn").unwrap();
    fs::create_dir(".learn").unwrap();
    let (is_right, words) = run(&["check", "set_pixel"]);
    assert!(is_right && words.contains("set_pixel: done"), "{words}");
    assert!(
        words.contains("what is done is not kept: .learn: "),
        "{words}"
    );
    fs::write(file("set_pixel"), b"a\n\xFF").unwrap();
    let (is_right, words) = run(&["check", "set_pixel"]);
    let latin = "exercises/set_pixel.rs: line 2 has a letter that is not in UTF-8";
    assert!(!is_right && words.contains(latin), "{words}");
    fs::write(file("set_pixel"), b"\xFF\xFEa\0").unwrap();
    let (is_right, words) = run(&["check", "set_pixel"]);
    assert!(!is_right && words.contains("a text in UTF-16"), "{words}");
}
