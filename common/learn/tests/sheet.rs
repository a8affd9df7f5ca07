//! A student's program and `cargo learn sheet`: what is said about pictures that are right, wrong or missing.

use std::fs::{self, File};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use common::{Color, picture_file};

const FOLDER: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/sheet");

/// The exercises of the workbook.
const LIST: &str = "[[exercise]]\nname = \"a\"\ntitle = \"A\"\nminutes = 1\n";

const SHEET: &str = r#"
title = "Edges"
page = "sheet-glass.md"
stage = "a01"
hours = 1
timed = "noise"

[[picture]]
scene = "edge"
samples = [1]
size = [40, 30]
seconds = 3

[[picture]]
scene = "noise"
samples = [4, 16, 64]
size = [40, 30]

[[fact]]
name = "place"
says = "white begins in column 20"
scene = "edge"
measure = "edge"
from = [5, 10]
to = [35, 10]
value = 14.5
formula = "19.5 - 5"
within = 0.01
because = "bytes are black or white"
hint = "Count columns from 0."

[[fact]]
name = "noise"
says = "the error falls as 1/√n"
scene = "noise"
measure = "slope"
region = [2, 2, 36, 26]
exact = 0.5
samples = [4, 16, 64]
value = -0.5
formula = "log(1/2) / log 4"
within = 0.02
because = "rounding to bytes changes an error by less than 1/510"
hint = "Are the samples independent?"

[fact.theory]
name = "independent samples"
errors = [0.25, 0.125, 0.0625]
formula = "1 / (2 √n)"
unseen = "Nothing is."
"#;

/// A program without libraries. Its pictures are BMP files, which open, whatever they are called.
const PROGRAM: &str = r#"
fn main() -> Result<(), String> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let mut n: f64 = words[2].parse().unwrap();
    let mistake = std::env::var("MISTAKE").unwrap_or_default();
    let bias = if mistake == "bias" { 0.05 } else { 0.0 };
    let is_shared = mistake == "shared";
    if mistake == "same" {
        n = 4.0;
    }
    let mut file = words[4].clone();
    let mut width = 40;
    let mut edge = 20;
    let colour = |x: i32, y: i32, edge: i32| {
        if words[0] == "edge" {
            if x < edge { 0.0 } else { 1.0 }
        } else {
            bias + 0.5 + if is_shared || (x + y) % 2 == 0 { 0.5 } else { -0.5 } / n.sqrt()
        }
    };
    match &*mistake {
        "another place" => edge = 22,
        "no edge" => edge = 40,
        "panic" => panic!("there is no scene {}", words[0]),
        "error" => return Err("no light".to_owned()),
        "exit" => std::process::exit(1),
        "no end" => loop {},
        "recursion" => println!("{}", deep(1)),
        "memory" => println!("{}", vec![1_u8; 3 << 30].iter().map(|n| usize::from(*n)).sum::<usize>()),
        "own picture" => file = "picture.png".to_owned(),
        "size" => width = 20,
        "text" => { std::fs::write(file, "red").unwrap(); return Ok(()); }
        "child" => {
            let mut child = std::process::Command::new(std::env::current_exe().unwrap());
            child.args(&words).env("MISTAKE", "hold");
            child.spawn().unwrap();
            while !std::path::Path::new("held").exists() {}
        }
        "hold" => {
            let lock = std::fs::File::create("lock").unwrap();
            lock.lock().unwrap();
            std::fs::write("held", "").unwrap();
            std::thread::sleep(std::time::Duration::from_secs(120));
        }
        "few" => if n > 9.0 { panic!("too many") },
        "late" => if words[0] == "noise" { panic!("no noise") },
        _ => {}
    }
    let mut bytes = b"BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0".to_vec();
    bytes.extend(i32::to_le_bytes(width));
    bytes.extend(30_i32.to_le_bytes());
    bytes.extend(b"\x01\0\x18\0");
    bytes.extend([0; 24]);
    for y in 0..30 {
        for x in 0..width {
            bytes.extend([(colour(x, y, edge) * 255.0 + 0.5) as u8; 3]);
        }
    }
    std::fs::write(file, bytes).unwrap();
    Ok(())
}

fn deep(n: u64) -> u64 {
    1 + std::hint::black_box(deep as fn(u64) -> u64)(n)
}
"#;

fn write(path: &str, text: &str) {
    let path = Path::new(FOLDER).join(path);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// What the command prints, first on the standard output, and whether it succeeds.
fn learn(arguments: &[&str], mistake: &str) -> (String, bool) {
    let mut learn = Command::new(env!("CARGO_BIN_EXE_learn"));
    learn.env("CARGO_MANIFEST_DIR", [FOLDER, "/common/learn"].concat());
    learn.env("MISTAKE", mistake).env_remove("CARGO_TARGET_DIR");
    learn.current_dir(FOLDER).arg("sheet").args(arguments);
    let output = learn.output().unwrap();
    let printed = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
    println!("--- {mistake}\n{printed}");
    (printed, output.status.success())
}

#[test]
fn each_program_gets_a_sentence() {
    let _ = fs::remove_dir_all(FOLDER);
    write("common/judge/sheets/glass.toml", SHEET);
    write("a01/exercises/exercises.toml", LIST);
    write("mine/src/main.rs", PROGRAM);

    let (printed, _) = learn(&[], "");
    assert!(
        printed.contains("glass       a01   1 h  Edges"),
        "{printed}"
    );
    let (printed, _) = learn(&["glass"], "");
    assert!(
        printed.contains("noise, 40x30 pixels, samples: 4, 16, 64"),
        "{printed}"
    );
    let (printed, _) = learn(&["gloss", "mine"], "");
    assert!(
        printed.contains("no sheet is called gloss; the nearest is glass"),
        "{printed}"
    );
    let (printed, _) = learn(&["glass", "mine"], "");
    assert!(printed.contains("mine has no Cargo.toml"), "{printed}");

    let manifest = "[package]\nname = \"mine\"\nedition = \"2024\"\n[workspace]\n";
    write("mine/Cargo.toml", manifest);
    let (printed, is_right) = learn(&["glass", "mine"], "");
    assert!(is_right, "{printed}");
    for words in [
        "ok         place  white begins in column 20",
        "noise, the median of 6 runs in turns",
        "   1.00 (1.00 to 1.00)",
        "This computer has ",
        "glass: 2 of 2 facts hold; the pictures are in out/sheets/glass",
    ] {
        assert!(printed.contains(words), "{words}: {printed}");
    }

    words_start_a_program();
    error_against_run_time();

    for (mistake, words) in [
        (
            "another place",
            "measured  16.5 (at 21.5, 10.0): pixels from the beginning to the edge",
        ),
        (
            "no edge",
            "there is no edge: the value is 0.000 at the beginning of the line and 0.000",
        ),
        (
            "panic",
            "edge, 1 sample: the program panics at src/main.rs:24:20: there is no scene edge",
        ),
        (
            "error",
            "the program ends with an error: Error: \"no light\"",
        ),
        ("exit", "the program ends with an error, without a word"),
        ("no end", "it takes longer than 3 seconds"),
        (
            "recursion",
            "the stack overflows, probably by a recursion without end",
        ),
        (
            "own picture",
            "no picture into the file after -o, but mine/picture.png: does `main`",
        ),
        (
            "size",
            "the picture has 20x30 pixels, and the sheet says 40x30",
        ),
        (
            "text",
            "cannot open out/sheets/glass/edge-1.png: it is no PNG, JPEG or BMP picture",
        ),
        ("late", "noise, 4 samples: the program panics"),
    ] {
        let (printed, is_right) = learn(&["glass", "mine"], mistake);
        assert!(!is_right && printed.contains(words), "{mistake}: {printed}");
        let count = if mistake == "late" {
            "1 of 2"
        } else {
            "0 of 2"
        };
        assert!(printed.contains(count), "{mistake}: {printed}");
    }
    let (printed, _) = learn(&["glass", "mine", "--all"], "another place");
    assert!(printed.contains("ok         noise"), "{printed}");
    let words = "marked    out/sheets/glass/edge-1.marked.png: the line and the edge in";
    assert!(printed.contains(words), "{printed}");
    let marked = Path::new(FOLDER).join("out/sheets/glass/edge-1.marked.png");
    let marked = picture_file::open(&marked).unwrap();
    // Its line is as it was, and has a frame.
    assert_eq!(marked.get(21, 10), Some(Color::BLACK));
    assert_eq!(marked.get(22, 10), Some(Color::WHITE));
    assert_ne!(marked.get(12, 7), Some(Color::BLACK));

    programs_end_within_their_limits();
    one_program_of_two_is_chosen(manifest);

    write("mine/src/main.rs", "fn main() { let x: i32 = 1.0; }");
    let (printed, _) = learn(&["glass", "mine"], "");
    assert!(printed.contains("mismatched types"), "{printed}");
    assert!(
        printed.contains("glass: mine does not compile"),
        "{printed}"
    );
}

/// The rounding to bytes makes the errors 0.249, 0.1235 and 0.0608, of which the slope is -0.51. With the bias,
/// the last errors are 0.1118 and -0.0137 in turn: blocks have their mean, 0.0490, pixels their root mean square, 0.0796, and
/// all pixels √((16 · 0.0490² - 0.0796²) / 15) = 0.046.
fn error_against_run_time() {
    let falls = "The error falls as theory says: half of it takes 3.9 times the samples.";
    for (mistake, says) in [
        ("", "slope over samples -0.51"),
        ("", falls),
        ("", "Since your last report: 1.00 times the error"),
        ("shared", "has each pixel random numbers of its own?"),
        ("bias", "An error of 0.046 stays"),
        (
            "same",
            "glass: 4 and 16 samples draw the same pixels: does the program use --samples?",
        ),
        ("few", "noise, 16 samples: the program panics"),
    ] {
        let (printed, is_drawn) = learn(&["glass", "mine", "--report"], mistake);
        assert!(printed.contains(says), "{mistake}: {printed}");
        assert_eq!(is_drawn, !matches!(mistake, "same" | "few"), "{printed}");
        let is_independent = !printed.contains("of its own") && !printed.contains("stays");
        assert_eq!(
            is_independent,
            !matches!(mistake, "shared" | "bias"),
            "{printed}"
        );
    }
    let pictures = Path::new(FOLDER).join("out/sheets/glass");
    // Five reports of three points each, below a head.
    let reports = fs::read_to_string(pictures.join("reports.csv")).unwrap();
    assert_eq!(reports.lines().count(), 1 + 5 * 3, "{reports}");
    let svg = fs::read_to_string(pictures.join("report.svg")).unwrap();
    for words in ["earlier reports", "independent samples", "run time (s)"] {
        assert!(svg.contains(words), "{words}: {svg}");
    }
}

/// Words start a program in any language, and further ones stand before the scene.
fn words_start_a_program() {
    for (words, says) in [
        ("target/release/mine", "2 of 2 facts hold"),
        ("target/release/mine further", "the program panics"),
        ("no-such-program my.py", "no-such-program"),
        (" ", "such as \"python3 my.py\""),
    ] {
        let (printed, _) = learn(&["glass", "mine", "--program", words], "");
        assert!(printed.contains(says), "{words}: {printed}");
    }
}

/// A program that needs too much memory, and one that leaves a child, which holds a lock.
fn programs_end_within_their_limits() {
    if cfg!(target_os = "linux") {
        let (printed, _) = learn(&["glass", "mine"], "memory");
        assert!(
            printed.contains("needs more memory than its limit"),
            "{printed}"
        );
    }
    if cfg!(unix) {
        let (printed, is_right) = learn(&["glass", "mine"], "child");
        assert!(is_right, "{printed}");
        let lock = File::open(Path::new(FOLDER).join("mine/lock")).unwrap();
        let end = Instant::now() + Duration::from_secs(10);
        while lock.try_lock().is_err() {
            assert!(Instant::now() < end, "a child of the program goes on");
        }
    }
}

/// The one that `cargo run` runs.
fn one_program_of_two_is_chosen(manifest: &str) {
    write("mine/src/bin/hello.rs", "fn main() {}");
    let (printed, _) = learn(&["glass", "mine"], "");
    assert!(
        printed.contains("it has 2 programs: hello, mine"),
        "{printed}"
    );
    let run = manifest.replace("edition", "default-run = \"mine\"\nedition");
    write("mine/Cargo.toml", &run);
    let (printed, is_right) = learn(&["glass", "mine"], "");
    assert!(is_right, "{printed}");
}
