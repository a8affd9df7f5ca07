//! Lists the exercises of each stage for the macro `exercises!`, so that a new exercise is two
//! files and no more: a starter or a solution, and a check of the same name.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

fn main() -> io::Result<()> {
    let folder = std::env::var_os("OUT_DIR").unwrap_or_default();
    let mut listed = File::create(Path::new(&folder).join("listed.rs"))?;
    writeln!(
        listed,
        "/// Calls `exercises!` with the exercises of a stage."
    )?;
    writeln!(listed, "#[macro_export]\nmacro_rules! listed {{")?;
    for stage in fs::read_dir("../..")? {
        let stage = stage?;
        let exercises = stage.path().join("exercises");
        let [starters, mut solutions] =
            ["starters", "solutions"].map(|folder| names(&exercises.join(folder)));
        // Where a starter has a file of its own, its check knows the solution.
        solutions.retain(|name| !starters.contains(name));
        if !(starters.is_empty() && solutions.is_empty()) {
            let stage = stage.file_name().to_string_lossy().replace('-', "_");
            let [starters, solutions] = [starters, solutions].map(|names| names.join(" "));
            let lists = format!("starters {{ {starters} }} solutions {{ {solutions} }}");
            writeln!(listed, "({stage} $names:tt) => {{")?;
            writeln!(listed, "$crate::exercises! {{ $names {lists} }} }};")?;
        }
    }
    writeln!(listed, "}}")
}

/// The names of the Rust files in a folder, which need not be there.
fn names(folder: &Path) -> Vec<String> {
    let Ok(files) = fs::read_dir(folder) else {
        return Vec::new();
    };
    println!("cargo::rerun-if-changed={}", folder.display());
    let files = files.filter_map(|file| file.ok()?.file_name().into_string().ok());
    let mut names: Vec<_> = files
        .filter_map(|file| Some(file.strip_suffix(".rs")?.to_owned()))
        .collect();
    names.sort();
    names
}
