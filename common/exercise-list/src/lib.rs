//! Lists the exercises of a stage for its program of exercises, so that a new exercise is two
//! files and no more: a starter or a solution, and a check of the same name.

use std::path::Path;
use std::{env, fs, io};

/// Writes `exercises.rs` into the output of the build script that calls it: a macro
/// `listed!(stage)`, which calls `testing::stage_exercises!` with the names of all exercises in
/// the folder `exercises` beside the build script.
///
/// `solved` are all that have a solution of their own. Of them `solutions` have no other starter
/// than that. `open` are starters without a solution, as in a workbook for students.
pub fn write() -> io::Result<()> {
    let starters = names("exercises/starters")?;
    let solved = names("exercises/solutions")?;
    let open = names("exercises/open")?;
    let mut solutions = solved.clone();
    solutions.retain(|name| !starters.contains(name));
    let mut list = "macro_rules! listed { ($stage:path) => { testing::stage_exercises! {\n\
         stage $stage;\n"
        .to_owned();
    let groups = [
        ("solved", solved),
        ("open", open),
        ("starters", starters),
        ("solutions", solutions),
    ];
    for (group, names) in groups {
        list += &format!("{group} {{\n    {}\n}}\n", names.join("\n    "));
    }
    list += "} } }\n";
    let folder = env::var_os("OUT_DIR").unwrap_or_default();
    fs::write(Path::new(&folder).join("exercises.rs"), list)
}

/// The names of the Rust files in a folder, which need not be there.
fn names(folder: &str) -> io::Result<Vec<String>> {
    println!("cargo::rerun-if-changed={folder}");
    if !Path::new(folder).is_dir() {
        return Ok(Vec::new());
    }
    let mut names = Vec::new();
    for file in fs::read_dir(folder)? {
        let file = file?.file_name().to_string_lossy().into_owned();
        names.extend(file.strip_suffix(".rs").map(str::to_owned));
    }
    names.sort();
    Ok(names)
}
