//! `cargo learn submit` in a small workbook: a program is packed without what tools add, and nothing else is replaced.

use std::fs;
use std::path::Path;
use std::process::Command;

use rawzip::ZipArchive;

const FOLDER: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/submit");

const LIST: &str =
    "[[exercise]]\nname = \"own\"\ntitle = \"Own\"\nminutes = 5\nhints = [\"Look.\"]\n";

fn write(path: &str, text: impl AsRef<[u8]>) {
    let path = Path::new(FOLDER).join(path);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// What the command prints.
fn submit(words: &[&str]) -> String {
    let mut learn = Command::new(env!("CARGO_BIN_EXE_learn"));
    let workbook = [FOLDER, "/workbook"].concat();
    learn.env("CARGO_MANIFEST_DIR", [&workbook, "/common/learn"].concat());
    learn.current_dir(workbook).arg("submit").args(words);
    let output = learn.output().unwrap();
    String::from_utf8([output.stdout, output.stderr].concat()).unwrap()
}

/// The names of the files in a zip file.
fn names(zip: &str) -> Vec<String> {
    let bytes = fs::read(Path::new(FOLDER).join("workbook").join(zip)).unwrap();
    let zip = ZipArchive::from_slice(&bytes).unwrap();
    let mut names = Vec::new();
    for entry in zip.entries() {
        names.push(String::from_utf8_lossy(entry.unwrap().file_path().as_ref()).into_owned());
    }
    names.sort();
    names
}

#[test]
fn a_program_is_packed_as_its_folder() {
    let _ = fs::remove_dir_all(FOLDER);
    write("workbook/a01/exercises/exercises.toml", LIST);
    write(
        "workbook/a01/exercises/solutions/own.rs",
        "pub fn own() {}\n",
    );
    write("my-tracer/Cargo.toml", "[package]\nname = \"mine\"\n");
    write("my-tracer/src/main.rs", "fn main() {}\n");
    write("my-tracer/earth.png", b"\x89PNG");
    write("my-tracer/target/release/mine", "old");
    let printed = submit(&["ada", "../my-tracer"]);
    assert!(printed.contains("lacks a file sheet.txt"), "{printed}");

    write("my-tracer/sheet.txt", "glass\n");
    for _ in 0..2 {
        let printed = submit(&["ada", "../my-tracer"]);
        assert!(printed.contains("a program of 4 files"), "{printed}");
    }
    let of_program = ["Cargo.toml", "earth.png", "sheet.txt", "src/main.rs"];
    assert_eq!(
        names("ada.zip"),
        of_program.map(|file| format!("my-tracer/{file}"))
    );

    write("workbook/a01/exercises/own.rs", "pub fn own() { }\n");
    submit(&["ada", "../my-tracer"]);
    assert_eq!(names("ada.zip")[0], "a01/exercises/own.rs");
    write("workbook/bob.zip", "a text of a person");
    let printed = submit(&["bob", "../my-tracer"]);
    assert!(
        printed.contains("has other files than a hand-in"),
        "{printed}"
    );
}
