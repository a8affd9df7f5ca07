//! `handout`: the workbook up to a stage, on request without solutions, whose answers its
//! checks then read from records.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use super::cut::cut;
use super::exercises;
use crate::exercise::Exercise;
use crate::files::{self, failed};
use crate::judgement;

/// The page for students, with `{stage}` in the place of the last stage.
const README: &str = include_str!("../../handout/README.md");

/// What Git has of the workbook, without the stages and their pages.
const PARTS: &str = ".cargo .gitignore Cargo.lock Cargo.toml LICENSE clippy.toml common";

/// For lecturers: writes a workbook for students
#[derive(clap::Args, Default)]
pub struct Handout {
    /// A new folder
    pub folder: PathBuf,
    /// The last stage, as a04 [default: all stages]
    #[arg(long, value_name = "STAGE")]
    pub until: Option<String>,
    /// Leaves out the solutions that are no lessons, and the proofs of checks
    #[arg(long)]
    pub without_solutions: bool,
    /// Hands out the laboratories, too
    #[arg(long)]
    pub with_labs: bool,
}

impl Handout {
    /// Writes the handout into a new or empty folder, and returns what it has.
    pub fn run(&self, course: &'static [Exercise]) -> Result<String, String> {
        let (folder, path) = (&self.folder, self.folder.display());
        if fs::read_dir(folder).is_ok_and(|mut folder| folder.next().is_some()) {
            return Err(format!("{path} is not empty; a handout needs a new folder"));
        }
        let chosen = exercises(course, self.until.as_ref())?;
        let mut contents = self.contents(chosen)?;
        for e in self.withheld(chosen) {
            let mut proofs = Command::new(judgement::proofs(e.stage)?);
            let record = said(proofs.env("EXERCISE_PRINTED", e.name))?;
            contents.insert(format!("{}/exercises/recorded/{}", e.stage, e.name), record);
        }
        for (path, bytes) in &contents {
            let path = folder.join(path);
            let made = path.parent().map_or(Ok(()), fs::create_dir_all);
            let written = made.and_then(|()| fs::write(&path, bytes));
            written.map_err(failed(&path))?;
        }
        // Cargo forgets the packages that the handout does not need.
        let mut cargo = Command::new("cargo");
        cargo.args(["metadata", "--format-version=1", "--quiet"]);
        said(cargo.current_dir(folder))?;
        let count = chosen.len();
        Ok(format!(
            "{path}: {count} exercises; test it: cargo test --workspace"
        ))
    }

    /// The exercises without their solutions, which have a file.
    fn withheld<'a>(&self, chosen: &'a [Exercise]) -> impl Iterator<Item = &'a Exercise> {
        let has_file = |e: &Exercise| e.solution.contains("/exercises/solutions/");
        let chosen = chosen.iter();
        chosen.filter(move |e| self.without_solutions && has_file(e))
    }

    /// The files by their paths, without records.
    fn contents(&self, chosen: &[Exercise]) -> Result<BTreeMap<String, Vec<u8>>, String> {
        // The numbers of stages are in the paths of their files, pages and pictures.
        let stages = chosen.iter().map(|e| format!("*{}-*", &e.stage[..3]));
        let parts = PARTS.split(' ').map(str::to_owned).chain(stages);
        let mut git = Command::new("git");
        git.args("ls-files -z --cached --others --exclude-standard".split(' '));
        let paths = said(git.args(parts).current_dir(files::workspace()))?;
        let paths = String::from_utf8_lossy(&paths).into_owned();
        let is_kept = |path: &&str| !path.contains("/tests/") || path.contains("/tests/exercises/");

        let mut contents = BTreeMap::new();
        for path in paths.split_terminator('\0').filter(is_kept) {
            let file = files::workspace().join(path);
            contents.insert(path.to_owned(), fs::read(&file).map_err(failed(&file))?);
        }
        for e in self.withheld(chosen) {
            contents.insert(e.solution.to_owned(), files::starter(e)?.into());
            // The proofs are the end of the file, from the second row of the variants on.
            let path = format!("{}/tests/exercises/{}.rs", e.stage, e.name);
            let check = files::read(&path)?;
            let (before, variants) = check.split_once("\nvariants! {").unwrap_or_default();
            let yours = variants.split(";\n").next().unwrap_or_default();
            let check = format!("#![allow(unused)]\n{before}\nvariants! {{{yours};\n}}\n");
            contents.insert(path, check.into());
        }
        if !self.with_labs {
            cut(&mut contents);
        }
        let workspace = contents.remove("Cargo.toml").unwrap_or_default();
        let workspace = String::from_utf8_lossy(&workspace).into_owned();
        let has = |member: &str| contents.contains_key(&format!("{member}/Cargo.toml"));
        let is_there = |line: &&str| match line.split(['"', '.']).collect::<Vec<_>>()[..] {
            ["    ", member, ","] => has(member),
            [stage, level] if stage.starts_with("a0") && level.starts_with("opt-level") => {
                has(stage)
            }
            _ => true,
        };
        let workspace: Vec<_> = workspace.lines().filter(is_there).collect();
        contents.insert("Cargo.toml".to_owned(), workspace.join("\n").into());
        let last = chosen.last().map_or("", |e| e.stage);
        let readme = README.replace("{stage}", last);
        contents.insert("README.md".to_owned(), readme.into());
        Ok(contents)
    }
}

/// The output of a program that must succeed.
fn said(program: &mut Command) -> Result<Vec<u8>, String> {
    let name = program.get_program().to_owned();
    let output = program.output().map_err(failed(name.as_ref()))?;
    if output.status.success() {
        return Ok(output.stdout);
    }
    let problem = [output.stdout, output.stderr].concat();
    Err(String::from_utf8_lossy(&problem).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_handout_has_no_line_of_a_solution() {
        let course = crate::exercise::read_all().unwrap();
        let handout = Handout {
            without_solutions: true,
            ..Handout::default()
        };
        let files = handout.contents(course).unwrap();
        let starters: String = course.iter().map(|e| files::starter(e).unwrap()).collect();
        let is_read = |path: &str| path.contains("/exercises/") || path.starts_with("book/src/a");
        let of_stages = files.iter().filter(|(path, _)| is_read(path));
        let texts = of_stages.map(|(_, bytes)| String::from_utf8_lossy(bytes));
        let text: String = texts.collect();
        let mut searched = 0;
        for e in handout.withheld(course) {
            let solution = files::read(e.solution).unwrap();
            // A shorter line, as a brace, says nothing.
            let is_long = |line: &&str| line.len() > 24 && !line.contains("missing!(");
            let is_own = |line: &&str| is_long(line) && !starters.contains(line);
            for line in solution.lines().map(str::trim).filter(is_own) {
                searched += 1;
                assert!(!text.contains(line), "{line} of {}", e.name);
            }
        }
        assert!(searched > 100, "{searched} lines of solutions");
    }
}
