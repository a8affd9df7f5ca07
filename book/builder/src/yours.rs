//! The reader's exercises as modules, one for each stage, so that a page can show the reader's
//! picture beside that of the lesson.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

use crate::command::not_started;
use crate::live_module::{FLAGS, TARGET, write_as_script};

/// An exercise of the reader's.
#[derive(Clone)]
pub struct Exercise {
    stage: String,
    name: String,
}

/// An exercise from its stage and its name, such as `a04-intersections/sphere`.
pub fn parse(text: &str) -> Result<Exercise, String> {
    let Some((stage, name)) = text.split_once('/') else {
        return Err("must be a stage and an exercise, such as a04-intersections/sphere".to_owned());
    };
    let path = Path::new(stage).join("exercises").join(name);
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .join(path)
        .with_extension("rs");
    if !path.is_file() {
        return Err(format!("there is no {stage}/exercises/{name}.rs"));
    }
    Ok(Exercise {
        stage: stage.to_owned(),
        name: name.to_owned(),
    })
}

/// What the pages need of the reader's exercises.
pub struct Yours {
    /// Tells the pages which exercises there are.
    pub script: String,
    /// The modules as scripts.
    pub modules: Vec<PathBuf>,
}

/// Builds a module for each stage. Exercises that do not compile are left out.
pub fn build(exercises: &[Exercise]) -> Result<Yours, String> {
    let mut by_stage: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for Exercise { stage, name } in exercises {
        by_stage.entry(stage).or_default().push(name);
    }
    let mut lines = Vec::new();
    let mut modules = Vec::new();
    for (stage, mut names) in by_stage {
        let module = match build_module(stage, &names, Stdio::inherit())? {
            Some(module) => Some(module),
            None => build_without_broken_files(stage, &mut names)?,
        };
        let Some(module) = module else {
            continue;
        };
        let path = PathBuf::from(format!("target/yours-{stage}.js"));
        write_as_script(&module, &path)?;
        modules.push(path);
        let quoted: Vec<String> = names.iter().map(|name| format!("'{name}'")).collect();
        lines.push(format!("    '{stage}': [{}],\n", quoted.join(", ")));
        println!(
            "beside pictures of {stage}, once clicked: those of your {}",
            names.join(" ")
        );
    }
    let script = if exercises.is_empty() {
        String::new()
    } else {
        format!("live.yours = {{\n{}}};\n", lines.concat())
    };
    Ok(Yours { script, modules })
}

/// The module without the files that alone do not compile either. None if nothing is left.
fn build_without_broken_files(
    stage: &str,
    names: &mut Vec<&str>,
) -> Result<Option<PathBuf>, String> {
    let all = names.len();
    let mut compiling = Vec::new();
    for name in names.drain(..) {
        if all > 1 && build_module(stage, &[name], Stdio::null())?.is_some() {
            compiling.push(name);
        } else {
            println!("left out: {stage}/exercises/{name}.rs");
        }
    }
    *names = compiling;
    if names.is_empty() {
        return Ok(None);
    }
    build_module(stage, names, Stdio::inherit())
}

/// The module of a stage's exercises with the reader's files of these names. None if they do not
/// compile; the compiler then says why.
fn build_module(stage: &str, names: &[&str], messages: Stdio) -> Result<Option<PathBuf>, String> {
    let mut cargo = Command::new("cargo");
    cargo.env("RUSTFLAGS", FLAGS).stderr(messages);
    cargo.args(["rustc", "--quiet", "--locked", "--no-default-features"]);
    cargo.args(["--package", stage, "--test", "exercises"]);
    cargo.args(["--profile", "live", "--target", TARGET]);
    cargo.args(["--message-format", "json-render-diagnostics"]);
    cargo.args(["--", "-A", "unused"]);
    for name in names {
        cargo.args(["--cfg", name]);
    }
    let output = cargo
        .output()
        .map_err(|error| not_started(&cargo, &error))?;
    if !output.status.success() {
        return Ok(None);
    }
    let messages = String::from_utf8_lossy(&output.stdout);
    let executable = messages.lines().find_map(executable_of_test);
    executable
        .map(Some)
        .ok_or_else(|| format!("cargo names no module of {stage}"))
}

/// The file that cargo has built, if this message in JSON is about a test.
fn executable_of_test(message: &str) -> Option<PathBuf> {
    let message: Value = serde_json::from_str(message).ok()?;
    let is_test = message["target"]["kind"][0] == "test";
    let executable = message["executable"].as_str().filter(|_| is_test);
    executable.map(PathBuf::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_module_is_that_of_the_test() {
        let message = r#"{"reason":"compiler-artifact","target":{"kind":["test"],"name":"exercises"},"executable":"C:\\target\\exercises.wasm","fresh":true}"#;
        let expected = PathBuf::from(r"C:\target\exercises.wasm");
        assert_eq!(executable_of_test(message), Some(expected));
        let library = message.replace("test", "lib");
        assert_eq!(executable_of_test(&library), None);
    }
}
