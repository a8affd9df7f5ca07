//! `cargo learn program` in a small workbook: what it refuses, it leaves as it is.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const FOLDER: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/program");

const LIST: &str = "[[exercise]]\nname = \"own\"\ntitle = \"Own\"\nminutes = 5\ncore = true\nhints = [\"Look.\"]\n";

const YOURS: &str = "use crate::prelude::*;\n\npub fn own() -> u8 {\n    1\n}\n";

const MANIFEST: &str = "[package]\nname = \"mine\"\nedition = \"2024\"\n";

fn write(path: &str, text: impl AsRef<[u8]>) {
    let path = Path::new(FOLDER).join(path);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// What the command prints, and whether it succeeds.
fn program(folder: &str) -> (String, bool) {
    let mut learn = Command::new(env!("CARGO_BIN_EXE_learn"));
    let workbook = [FOLDER, "/workbook"].concat();
    learn.env("CARGO_MANIFEST_DIR", [&workbook, "/common/learn"].concat());
    learn.current_dir(workbook).args(["program", folder]);
    let output = learn.output().unwrap();
    let printed = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
    println!("--- {folder}\n{printed}");
    (printed, output.status.success())
}

/// All files below a folder.
fn files(folder: &Path, found: &mut BTreeMap<PathBuf, Vec<u8>>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.is_symlink() {
            files(&path, found);
        } else {
            found.insert(path.clone(), fs::read(&path).unwrap_or_default());
        }
    }
}

#[test]
fn nothing_is_written_before_all_is_checked() {
    let _ = fs::remove_dir_all(FOLDER);
    for (path, text) in [
        ("Cargo.toml", "[workspace.dependencies]\nlibm = \"0.2\"\n"),
        ("Cargo.lock", "version = 4\n"),
        ("a01/Cargo.toml", MANIFEST),
        ("a01/exercises/exercises.toml", LIST),
        ("a01/exercises/solutions/own.rs", YOURS),
        ("a01/exercises/own.rs", YOURS),
        ("my-tracer/Cargo.toml", MANIFEST),
    ] {
        write(&format!("workbook/{path}"), text);
    }
    let hash = common::fnv1a(YOURS.as_bytes());
    write("workbook/.learn", format!("own {hash:016x}\n"));
    write("no-toml/Cargo.toml", "[package\n");
    write("number/Cargo.toml", "dependencies = 1\n");
    write("own-functions/Cargo.toml", MANIFEST);
    // A letter that is not in UTF-8 belongs to somebody, too.
    write("own-functions/src/functions.rs", b"// \xE4");
    write("empty/other", "");
    #[cfg(unix)]
    std::os::unix::fs::symlink("workbook/my-tracer", [FOLDER, "/link"].concat()).unwrap();

    let mut before = BTreeMap::new();
    files(Path::new(FOLDER), &mut before);
    let within = "is within the workbook, and a program of your own is outside of it";
    for (folder, words) in [
        (".", within),
        ("a01", within),
        ("my-tracer", within),
        ("no-folder", within),
        ("../workbook/a01/../my-tracer", within),
        #[cfg(unix)]
        ("../link", within),
        ("../empty", "has no Cargo.toml: `cargo new ../empty` begins"),
        ("../no-folder", "`cargo new ../no-folder` begins"),
        ("../no-toml", "../no-toml/Cargo.toml: TOML parse error"),
        ("../number", "../number/Cargo.toml: TOML parse error"),
        (
            "../own-functions",
            "../own-functions/src/functions.rs is yours",
        ),
    ] {
        let (printed, is_right) = program(folder);
        let printed = printed.replace('\n', " ");
        assert!(!is_right && printed.contains(words), "{folder}: {printed}");
        let mut after = BTreeMap::new();
        files(Path::new(FOLDER), &mut after);
        assert_eq!(after, before, "{folder}");
    }

    write("mine/Cargo.toml", MANIFEST);
    write("mine/src/functions/own.rs", b"// \xE4");
    let (printed, is_right) = program("../mine");
    assert!(is_right, "{printed}");
    for words in [
        "../mine/Cargo.toml gets libm, common, [profile.dev], [profile.release]; the next build",
        "edited there, and so left as they are: own",
        "../mine/src/main.rs calls them after the lines: mod functions; use functions::*;",
    ] {
        assert!(
            printed.replace('\n', " ").contains(words),
            "{words}: {printed}"
        );
    }
    assert!(!printed.contains("your functions"), "{printed}");
    let edited = Path::new(FOLDER).join("mine/src/functions/own.rs");
    assert_eq!(fs::read(&edited).unwrap(), b"// \xE4");
    fs::remove_file(edited).unwrap();
    let (printed, _) = program("../mine");
    assert!(printed.contains("your functions: own"), "{printed}");
    assert!(!printed.contains("gets"), "{printed}");
}
