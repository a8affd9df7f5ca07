//! What Cargo says as JSON: which program `cargo run` runs, and where a build has put a program.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::files::with_path;

/// The kind of a program that is built.
#[derive(Clone, Copy)]
pub enum Kind<'a> {
    /// A test, which asks the code of exercises.
    Test,
    /// A program of this name.
    Bin(&'a str),
}

/// The path of the program in the messages of its build.
pub fn find_program(messages: &str, kind: Kind) -> Result<String, String> {
    for line in messages.lines() {
        let Ok(message) = serde_json::from_str::<Value>(line) else {
            continue;
        };
        let target = &message["target"];
        let is_wanted = match kind {
            Kind::Test => target["kind"][0] == "test",
            Kind::Bin(name) => target["kind"][0] == "bin" && target["name"] == name,
        };
        if let Some(program) = message["executable"].as_str().filter(|_| is_wanted) {
            return Ok(program.to_owned());
        }
    }
    Err("cargo has built no program".to_owned())
}

/// What Cargo knows of the packages in a folder.
///
/// # Errors
///
/// Fails with the words of Cargo.
pub fn metadata(folder: &Path) -> Result<Value, String> {
    const WORDS: &str = "metadata --no-deps --offline --format-version 1";
    let mut cargo = Command::new("cargo");
    let output = cargo.args(WORDS.split(' ')).current_dir(folder).output();
    let output = output.map_err(with_path("cargo".as_ref()))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata: {error}"))
}

/// The name of the program that `cargo run` runs, among those of the packages that Cargo builds: the one of `default-run`, or
/// the only one.
///
/// # Errors
///
/// Fails where Cargo would ask which of several programs it is to run.
pub fn program_of(metadata: &Value) -> Result<String, String> {
    let list = |value: &'_ Value| value.as_array().cloned().unwrap_or_default();
    let built = list(&metadata["workspace_default_members"]);
    let (mut chosen, mut names) = (Vec::new(), Vec::new());
    for package in list(&metadata["packages"]) {
        if !built.contains(&package["id"]) {
            continue;
        }
        chosen.extend(package["default_run"].as_str().map(str::to_owned));
        for target in list(&package["targets"]) {
            let name = target["name"].as_str();
            names.extend(
                name.filter(|_| target["kind"][0] == "bin")
                    .map(str::to_owned),
            );
        }
    }
    names.sort();
    match (&chosen[..], &names[..]) {
        ([name], _) | ([], [name]) => Ok(name.clone()),
        (_, []) => Err("it has no program: src/main.rs is missing".to_owned()),
        _ => Err(format!(
            "it has {} programs: {}; a line `default-run = \"{}\"` in [package] of its Cargo.toml says which one counts",
            names.len(),
            names.join(", "),
            names[0],
        )),
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    const MAIN: &str = "fn main() {}";

    /// The program of a package `my-tracer` with these lines and files, or of a workspace around it.
    fn program(lines: &str, files: &[&str]) -> String {
        let folder = tempfile::tempdir().unwrap();
        let package = folder.path().join("my-tracer");
        for path in files {
            let file = package.join(path);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, MAIN).unwrap();
        }
        let manifest = format!("[package]\nname = \"my-tracer\"\nedition = \"2024\"\n{lines}");
        fs::write(package.join("Cargo.toml"), manifest).unwrap();
        let workspace = "[workspace]\nmembers = [\"my-tracer\"]\nresolver = \"3\"\n";
        fs::write(folder.path().join("Cargo.toml"), workspace).unwrap();
        let program_in = |folder: &Path| metadata(folder).and_then(|found| program_of(&found));
        let of_package = program_in(&package);
        assert_eq!(program_in(folder.path()).ok(), of_package.clone().ok());
        of_package.unwrap_or_else(|problem| problem)
    }

    #[test]
    fn the_program_is_the_one_that_cargo_runs() {
        let (main, hello) = ("src/main.rs", "src/bin/hello.rs");
        assert_eq!(program("", &[main]), "my-tracer");
        assert_eq!(program("", &[hello]), "hello");
        assert_eq!(
            program("", &[main, "examples/hello.rs", "src/lib.rs"]),
            "my-tracer"
        );
        assert_eq!(program("default-run = \"hello\"", &[main, hello]), "hello");
        assert_eq!(
            program(
                "autobins = false\n[[bin]]\nname = \"other\"\npath = \"src/a.rs\"",
                &["src/a.rs", hello]
            ),
            "other"
        );
        let two = program("", &[main, hello]);
        assert!(
            two.starts_with("it has 2 programs: hello, my-tracer; a line `default-run"),
            "{two}"
        );
        let none = program("", &["src/lib.rs"]);
        assert!(none.starts_with("it has no program"), "{none}");
        let broken = program("default-run = 1", &[main]);
        assert!(broken.contains("default-run"), "{broken}");
    }

    #[test]
    fn a_program_is_found_in_the_messages_of_its_build() {
        let artifact = |kind: &str, name: &str, path: &str| {
            format!(
                r#"{{"reason":"compiler-artifact","target":{{"kind":["{kind}"],"name":"{name}"}},"executable":{path}}}"#
            )
        };
        let messages = [
            artifact("lib", "common", "null"),
            artifact("bin", "hello", r#""/target/hello""#),
            artifact("bin", "my-tracer", r#""C:\\target\\my-tracer.exe""#),
            artifact("test", "exercises", r#""/target/\u00e4""#),
            "no message".to_owned(),
        ]
        .join("\n");
        let found = |kind| find_program(&messages, kind);
        assert_eq!(
            found(Kind::Bin("my-tracer")).unwrap(),
            r"C:\target\my-tracer.exe"
        );
        assert_eq!(found(Kind::Test).unwrap(), "/target/ä");
        assert!(found(Kind::Bin("other")).is_err());
    }
}
