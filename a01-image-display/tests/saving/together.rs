//! Two programs that save under the same name at the same time.

use std::fs;
use std::process::{Command, Stdio};

use crate::{folder, names, program, write_noise};

#[test]
fn of_two_programs_that_save_at_once_one_picture_is_whole() {
    let folder = folder();
    let path = |name| folder.path().join(name);
    let lines = [(1, "a.png"), (2, "b.png")].map(|(seed, name)| {
        write_noise(&path(name), 300, seed);
        format!("render show-image --open {name} -o saved.png")
    });
    let whole = lines.each_ref().map(|line| {
        run_at_once([program(folder.path(), line)]);
        fs::read(path("saved.png")).unwrap()
    });
    assert!(whole[0] != whole[1]);
    let mut won = [0, 0];
    for round in 0..20 {
        run_at_once(lines.each_ref().map(|line| program(folder.path(), line)));
        let saved = fs::read(path("saved.png")).unwrap();
        let winner = whole.iter().position(|whole| *whole == saved);
        won[winner.unwrap_or_else(|| panic!("half a picture in round {round}"))] += 1;
    }
    println!("won: {won:?}");
    assert_eq!(names(folder.path()), ["a.png", "b.png", "saved.png"]);
}

/// A program accepts that the other one has made the folder meanwhile.
#[test]
fn two_programs_make_the_same_folder_at_once() {
    for _ in 0..40 {
        let folder = folder();
        let lines = ["render painter --size 8x8", "render diagonal --size 8x8"];
        run_at_once(lines.map(|line| program(folder.path(), line)));
        let files = ["diagonal", "painter"].map(|name| format!("a01-image-display-{name}.png"));
        assert_eq!(names(&folder.path().join("out")), files);
    }
}

/// All must succeed.
fn run_at_once<const N: usize>(mut programs: [Command; N]) {
    let started = programs.each_mut().map(|program| {
        let silent = program.stdout(Stdio::null()).stderr(Stdio::piped());
        silent.spawn().expect("the program runs")
    });
    for program in started {
        let output = program.wait_with_output().expect("an end");
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{complaint}");
    }
}
