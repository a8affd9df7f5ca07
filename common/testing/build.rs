//! Lists the exercises of each stage for the macro `exercises!`, so that a new exercise is two
//! files and no more: a starter or a solution, and a check of the same name.

use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let mut lists = String::new();
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
            lists += &format!(
                "({stage} $names:tt) => {{ $crate::exercises! {{ $names \
                 starters {{ {starters} }} solutions {{ {solutions} }} }} }};\n"
            );
        }
    }
    let about = "/// Calls `exercises!` with the exercises of a stage.";
    let listed = format!("{about}\n#[macro_export]\nmacro_rules! listed {{\n{lists}}}\n");
    let folder = env::var_os("OUT_DIR").unwrap_or_default();
    fs::write(Path::new(&folder).join("listed.rs"), listed)
}

/// The names of the Rust files in a folder, which need not be there.
fn names(folder: &Path) -> Vec<String> {
    let Ok(files) = fs::read_dir(folder) else {
        return Vec::new();
    };
    println!("cargo::rerun-if-changed={}", folder.display());
    let paths = files.filter_map(|file| Some(file.ok()?.path()));
    let rust = paths.filter(|path| path.extension().is_some_and(|end| end == "rs"));
    let mut names: Vec<_> = rust
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .collect();
    names.sort();
    names
}
