//! Each starter names, in its code or its comments, what of the workbook the missing part calls: nobody has to find
//! the name of a method in another file.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use learn::{exercise, files, starter};

/// Names that the standard library has, too, of which a learner of Rust knows.
const OF_RUST: [&str; 5] = ["default", "find", "from", "get", "map"];

#[test]
fn starters_name_what_solutions_call() {
    let offered = functions_of_the_workbook();
    let mut lacking = Vec::new();
    for e in exercise::read_all().unwrap() {
        let solution = files::read(&e.solution_file()).unwrap();
        let starter = starter(e).unwrap();
        for call in calls(&solution).difference(&calls(&starter)) {
            let name = call.rsplit("::").next().unwrap();
            let is_own = solution.contains(&format!("let {name} = |"));
            if offered.contains(name) && !OF_RUST.contains(&name) && !is_own {
                lacking.push(format!("{}: {call}", e.name));
            }
        }
    }
    assert!(lacking.is_empty(), "no starter names {lacking:#?}");
}

/// What a text calls: methods by their names, and functions of types with these, such as `Hit::new`.
fn calls(text: &str) -> BTreeSet<String> {
    let is_of_path = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let mut calls = BTreeSet::new();
    for (at, _) in text.match_indices('(') {
        let before = &text[..at];
        let name = before.trim_end_matches(is_of_path);
        calls.insert(before[name.len()..].to_owned());
    }
    calls
}

/// The names of all public functions, and of those in an `impl` or a trait.
fn functions_of_the_workbook() -> BTreeSet<String> {
    let mut folders = vec![files::workspace().join("common/src")];
    for stage in exercise::read_all().unwrap().iter().map(|e| e.stage) {
        folders.push(files::workspace().join(stage).join("src"));
    }
    folders.dedup();
    let mut names = BTreeSet::new();
    for folder in folders {
        for path in rust_files(folder) {
            let text = fs::read_to_string(path).unwrap();
            for line in text.lines() {
                if let Some((before, rest)) = line.split_once("fn ")
                    && (before.starts_with("pub ") || before.starts_with("    "))
                {
                    let name = rest.split(|c: char| !c.is_alphanumeric() && c != '_');
                    names.extend(name.map(str::to_owned).next());
                }
            }
        }
    }
    names
}

/// The files of a folder, without those of folders in it.
fn rust_files(folder: PathBuf) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().flatten();
    let paths = entries.map(|entry| entry.path());
    paths
        .filter(|path| path.extension().is_some_and(|end| end == "rs"))
        .collect()
}
