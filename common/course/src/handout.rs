//! `handout`: whole folders of the workbook up to a stage, on request without solutions: checks
//! need no more than the recorded answers.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use learn::exercise::Exercise;
use learn::files::{self, with_path};

use crate::exercises;
use crate::grading_folder::{Workbook, output_of};

/// The page for students, with `{stage}` instead of the last stage.
const README: &str = include_str!("../handout/README.md");

/// The files and folders that are handed out.
const PARTS: [&str; 15] = [
    ".cargo",
    ".gitignore",
    "Cargo.lock",
    "Cargo.toml",
    "LICENSE",
    "clippy.toml",
    "common",
    "book/src",
    "a0*",
    // They need all stages, or other libraries, or are for lecturers.
    ":(exclude)common/course",
    ":(exclude)common/fuzz",
    ":(exclude)common/corpus/adapters",
    ":(exclude)a0*/exercises/others/*",
    ":(exclude)common/sheet/answers",
    ":(exclude)common/sheet/facts",
];

/// What a handout lacks that ends before the last stage.
const PART_TWO: [&str; 3] = [
    ":(exclude)common/sheet/sheets",
    ":(exclude)book/src/part-two.md",
    ":(exclude)book/src/*sheet-*",
];

/// Writes a workbook for students
#[derive(clap::Args, Default)]
pub struct Handout {
    /// A new folder
    pub folder: PathBuf,
    /// The last stage, such as a04 [default: all stages]
    #[arg(long, value_name = "STAGE")]
    pub until: Option<String>,
    /// Leaves out the solutions that are no lessons
    #[arg(long)]
    pub without_solutions: bool,
}

impl Handout {
    /// Writes the handout into a new or empty folder, and returns what it has.
    pub fn run(&self, course: &'static [Exercise]) -> Result<String, String> {
        let folder = &self.folder;
        let shown = folder.display();
        if fs::read_dir(folder).is_ok_and(|mut folder| folder.next().is_some()) {
            return Err(format!(
                "{shown} is not empty; a handout needs a new folder"
            ));
        }
        for (path, bytes) in &self.workbook(course)? {
            let path = folder.join(path);
            if let Some(folder) = path.parent() {
                fs::create_dir_all(folder).map_err(with_path(folder))?;
            }
            fs::write(&path, bytes).map_err(with_path(&path))?;
        }
        // Cargo forgets the packages that the handout does not need.
        let mut cargo = Command::new("cargo");
        cargo.args(["update", "--workspace", "--offline", "--quiet"]);
        output_of(cargo.current_dir(folder))?;
        let count = exercises(course, self.until.as_ref())?.len();
        Ok(format!(
            "{shown}: {count} exercises; test it: cargo test --workspace"
        ))
    }

    /// The files of the workbook.
    pub fn workbook(&self, course: &'static [Exercise]) -> Result<Workbook, String> {
        let chosen = exercises(course, self.until.as_ref())?;
        let mut workbook = Workbook::new();
        for path in paths(&course[chosen.len()..])? {
            let file = files::workspace().join(&path);
            let bytes = fs::read(&file).map_err(with_path(&file))?;
            workbook.insert(path, bytes);
        }
        if self.without_solutions {
            withhold_solutions(&mut workbook, chosen)?;
        }
        let manifest = workbook.remove("Cargo.toml").unwrap_or_default();
        let manifest = String::from_utf8_lossy(&manifest);
        let manifest = members_in(&manifest, &workbook);
        workbook.insert("Cargo.toml".to_owned(), manifest.into());
        let config = workbook.remove(".cargo/config.toml").unwrap_or_default();
        let config = students_aliases(&String::from_utf8_lossy(&config));
        workbook.insert(".cargo/config.toml".to_owned(), config.into());
        let last = chosen.last().map_or("", |e| e.stage);
        let readme = README.replace("{stage}", last);
        workbook.insert("README.md".to_owned(), readme.into());
        Ok(workbook)
    }
}

/// The paths of the files that are handed out, without those of the stages above: the numbers of
/// stages are in the paths of their files, pages and pictures.
fn paths(above: &[Exercise]) -> Result<Vec<String>, String> {
    let mut git = Command::new("git");
    git.args([
        "ls-files",
        "-z",
        "--cached",
        "--others",
        "--exclude-standard",
    ]);
    git.args(PARTS);
    if !above.is_empty() {
        git.args(PART_TWO);
    }
    for e in above {
        git.arg(format!(":(exclude)*{}-*", &e.stage[..3]));
    }
    let paths = output_of(git.current_dir(files::workspace()))?;
    let paths = String::from_utf8_lossy(&paths);
    Ok(paths.split_terminator('\0').map(str::to_owned).collect())
}

/// Replaces solutions that are no lessons by their starters, which are not proved.
fn withhold_solutions(workbook: &mut Workbook, chosen: &[Exercise]) -> Result<(), String> {
    for e in chosen.iter().filter(|e| !e.is_core) {
        let path = format!("{}/exercises/solutions/{}.rs", e.stage, e.name);
        workbook.insert(path, files::starter(e)?.into());
    }
    Ok(())
}

/// The manifest of the workspace without the members and the profiles of stages that are not
/// handed out.
fn members_in(manifest: &str, workbook: &Workbook) -> String {
    let mut text = String::new();
    for line in manifest.lines() {
        let folder = match line.split(['"', '.']).collect::<Vec<_>>()[..] {
            ["    ", member, ","] => format!("{member}/Cargo.toml"),
            [package, level] if package.starts_with("a0") && level.starts_with("opt-level") => {
                package[..3].to_owned()
            }
            _ => String::new(),
        };
        if workbook.keys().any(|path| path.starts_with(&folder)) {
            text += line;
            text += "\n";
        }
    }
    text
}

/// The configuration of Cargo without the aliases of packages that are not handed out, and without
/// comments.
fn students_aliases(config: &str) -> String {
    let mut text = String::new();
    for line in config.lines() {
        let is_others = line.contains("--package ") && !line.contains("--package learn ");
        if !is_others && !line.starts_with('#') {
            text += line;
            text += "\n";
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_handout_has_starters_instead_of_solutions() {
        if !files::workspace().join(".git").exists() {
            eprintln!("skipped: a handout is written by a workbook in Git");
            return;
        }
        let course = learn::exercise::read_all().unwrap();
        let handout = Handout {
            without_solutions: true,
            ..Handout::default()
        };
        let contents = handout.workbook(course).unwrap();
        for e in course.iter().filter(|e| !e.is_core) {
            let path = format!("{}/exercises/solutions/{}.rs", e.stage, e.name);
            let starter = files::starter(e).unwrap();
            assert_eq!(contents[&path], starter.into_bytes(), "{}", e.name);
        }
        for path in contents.keys() {
            assert!(!path.starts_with("common/course/"), "{path}");
            assert!(!path.contains("/exercises/others/"), "{path}");
        }
        let aliases = String::from_utf8_lossy(&contents[".cargo/config.toml"]);
        assert!(aliases.contains("--package learn"), "{aliases}");
        assert!(!aliases.contains("--package course"), "{aliases}");
    }
}
