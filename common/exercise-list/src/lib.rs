//! Lists the exercises of a stage for its program of exercises, so that a new exercise is two
//! files and no more: a starter or a solution, and a check of the same name.

use std::path::Path;
use std::{env, fs, io};

/// Writes `exercises.rs` into the output of the build script that calls it: a macro `exercises!()`,
/// which calls `testing::exercises!` with the names of all exercises in the folder `exercises` beside
/// the build script. A macro, because modules are looked for beside the file with the call.
///
/// `solved` are all that have a solution of their own. Of them `solutions` have no other starter
/// than that. `open` are starters without a solution, as in a workbook for students. `hints` are
/// starters with the lines of their first hint in the right order.
pub fn write() -> io::Result<()> {
    let starters = names("exercises/starters")?;
    let solved = names("exercises/solutions")?;
    let open = names("exercises/open")?;
    let mut hints = names("exercises/hints")?;
    hints.retain(|name| starters.contains(name));
    let mut solutions = solved.clone();
    solutions.retain(|name| !starters.contains(name));
    let stage = env::var("CARGO_PKG_NAME").unwrap_or_default();
    let stage = stage.replace('-', "_");
    let mut list = format!(
        "macro_rules! exercises {{ () => {{ testing::exercises! {{\n    stage {stage}::stage;\n"
    );
    let groups = [
        ("solved", solved),
        ("open", open),
        ("hints", hints),
        ("starters", starters),
        ("solutions", solutions),
    ];
    for (group, names) in groups {
        list.extend(["    ", group, " { ", &names.join(" "), " }\n"]);
    }
    list += "} } }\n";
    let folder = env::var_os("OUT_DIR").unwrap_or_default();
    fs::write(Path::new(&folder).join("exercises.rs"), list)
}

/// The names of the Rust files in a folder, which need not be there.
fn names(folder: &str) -> io::Result<Vec<String>> {
    if !Path::new(folder).is_dir() {
        return Ok(Vec::new());
    }
    // Of a folder that is missing, Cargo would think that it has changed, and compile the stage anew
    // for each command. The whole folder `exercises` holds the students' files, too.
    println!("cargo::rerun-if-changed={folder}");
    let mut names = Vec::new();
    for file in fs::read_dir(folder)? {
        let file = file?.file_name().to_string_lossy().into_owned();
        names.extend(file.strip_suffix(".rs").map(str::to_owned));
    }
    names.sort();
    Ok(names)
}
