//! A class in the grader's sandbox: what a student does harms neither the others nor the verdict about themselves.
//!
//! `.ci/run` runs it: the grader builds the workbook once more for it.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use learn::exercise::{self, Exercise};
use learn::{files, starter};

const FOLDER: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/class");

/// Behind a macro, a program can print the file of the exercise, and no right answer is in it.
const FORGED: &str = r#"use crate::prelude::*;
macro_rules! hidden { ($a:ident $($b:ident)+) => { std::$a$(::$b)+ } }
pub fn set_pixel(_: &mut Image, _: u32, _: u32, _: Color) {
    let file = (hidden!(fs read_to_string))("a01-image-display/exercises/answers/set_pixel.txt").unwrap();
    print!("\u{1c}");
    for answer in file.lines().filter_map(|line| line.split(" = ").nth(1)?.split(" ~ ").next()) {
        println!("? a question\n= {answer}");
    }
    (hidden!(process exit))(0);
}
"#;

/// A file that is at the end as it was before.
struct Kept {
    path: PathBuf,
    text: String,
}

impl Kept {
    fn new(path: PathBuf) -> Self {
        let text = fs::read_to_string(&path).unwrap();
        Self { path, text }
    }
}

impl Drop for Kept {
    fn drop(&mut self) {
        fs::write(&self.path, &self.text).unwrap();
    }
}

fn hand_in(student: &str, name: &str, text: &str) {
    let folder = Path::new(FOLDER).join(student);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join(format!("{name}.rs")), text).unwrap();
}

fn solution(e: &Exercise) -> String {
    files::read(&e.solution_file()).unwrap()
}

/// What a command prints, and whether it succeeds.
fn course(arguments: &[&str]) -> (String, bool) {
    let mut course = Command::new(env!("CARGO_BIN_EXE_course"));
    course.current_dir(files::workspace()).args(arguments);
    let output = course.output().unwrap();
    let printed = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
    println!("--- {arguments:?}\n{printed}");
    (printed, output.status.success())
}

#[test]
#[ignore = "the grader builds the workbook, which takes minutes"]
fn each_student_gets_a_verdict_of_their_own() {
    let _ = fs::remove_dir_all(FOLDER);
    let all = exercise::read_all().unwrap();
    for e in all {
        hand_in("ada", e.name, &solution(e));
    }
    let [pixel, reflected] = ["set_pixel", "reflected"].map(|name| exercise::find(name).unwrap());
    hand_in("bob", "set_pixel", FORGED);
    // A file that does not compile harms none of the same student.
    hand_in("cleo", "set_pixel", &solution(pixel));
    hand_in("cleo", "diagonal", "pub fn");
    hand_in("dan", "reflected", &starter(reflected).unwrap());
    let wrong = solution(reflected).replace("along - rest\n", "along - rest - v\n");
    for student in ["eve", "fay"] {
        hand_in(student, "reflected", &wrong);
    }
    fs::write(Path::new(FOLDER).join("gil.zip"), "text").unwrap();

    let (printed, is_judged) = course(&["grade", FOLDER]);
    assert!(!is_judged, "a broken zip file counts as judged");
    let count = all.len();
    for words in [
        &*format!("ada: {count} right"),
        "set_pixel: wrong, bob/",
        "set_pixel: right, cleo/",
        "diagonal: wrong, cleo/",
        "to do: the reflected vector",
        "gil.zip (it is no zip file",
        "2 of reflected, such as eve's",
    ] {
        assert!(printed.contains(words), "{words}");
    }
    // Nobody finds the program of another one.
    let programs = files::workspace().join("target/grading/target/debug/deps");
    let mut count = 0;
    for file in fs::read_dir(programs).unwrap() {
        let name = file.unwrap().file_name().into_string().unwrap();
        count += usize::from(name.starts_with("exercises-") && !name.contains('.'));
    }
    assert_eq!(count, 1);

    // Two students make a mistake that has no sentence; with one, both read it.
    let (_, file) = printed.split_once("cargo course mistake ").unwrap();
    let (file, _) = file.split_once(' ').unwrap();
    let fact = "v counts once";
    let answers = "a02-math/exercises/answers/reflected.txt";
    let kept = Kept::new(files::workspace().join(answers));
    let (_, is_recorded) = course(&["mistake", file, fact]);
    let (printed, _) = course(&["grade", FOLDER, "--exercises", "reflected"]);
    drop(kept);
    assert!(is_recorded);
    let words = format!("overlooks that {fact}");
    assert_eq!(printed.matches(&words).count(), 2);
}
