//! `handout`: whole folders of the workbook up to a stage, on request without solutions: checks
//! need no more than the recorded answers.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use super::exercises;
use crate::exercise::Exercise;
use crate::files::{self, failed};

/// The page for students, with `{stage}` instead of the last stage.
const README: &str = include_str!("../../handout/README.md");

/// The files and folders that are handed out.
const PARTS: &str =
    ".cargo .gitignore Cargo.lock Cargo.toml LICENSE clippy.toml common book/src a0*";

/// For lecturers: writes a workbook for students
#[derive(clap::Args, Default)]
pub struct Handout {
    /// A new folder
    pub folder: PathBuf,
    /// The last stage, as a04 [default: all stages]
    #[arg(long, value_name = "STAGE")]
    pub until: Option<String>,
    /// Leaves out the folders of solutions, which are those that are no lessons
    #[arg(long)]
    pub without_solutions: bool,
}

impl Handout {
    /// Writes the handout into a new or empty folder, and returns what it has.
    pub fn run(&self, course: &'static [Exercise]) -> Result<String, String> {
        let (folder, path) = (&self.folder, self.folder.display());
        if fs::read_dir(folder).is_ok_and(|mut folder| folder.next().is_some()) {
            return Err(format!("{path} is not empty; a handout needs a new folder"));
        }
        let chosen = exercises(course, self.until.as_ref())?;
        for (path, bytes) in &self.contents(course, chosen)? {
            let path = folder.join(path);
            let made = path.parent().map_or(Ok(()), fs::create_dir_all);
            let written = made.and_then(|()| fs::write(&path, bytes));
            written.map_err(failed(&path))?;
        }
        // Cargo forgets the packages that the handout does not need.
        let mut cargo = Command::new("cargo");
        cargo.args(["metadata", "--format-version=1", "--quiet"]);
        output_of(cargo.current_dir(folder))?;
        let count = chosen.len();
        Ok(format!(
            "{path}: {count} exercises; test it: cargo test --workspace"
        ))
    }

    /// The files by their paths.
    fn contents(
        &self,
        course: &[Exercise],
        chosen: &[Exercise],
    ) -> Result<BTreeMap<String, Vec<u8>>, String> {
        // The numbers of stages are in the paths of their files, pages and pictures.
        let above = course[chosen.len()..].iter();
        let above = above.map(|e| format!(":(exclude)*{}-*", &e.stage[..3]));
        let parts = PARTS.split(' ').map(str::to_owned).chain(above);
        let mut git = Command::new("git");
        git.args("ls-files -z --cached --others --exclude-standard".split(' '));
        let paths = output_of(git.args(parts).current_dir(files::workspace()))?;
        let paths = String::from_utf8_lossy(&paths).into_owned();
        let mut contents = BTreeMap::new();
        for path in paths.split_terminator('\0') {
            let file = files::workspace().join(path);
            contents.insert(path.to_owned(), fs::read(&file).map_err(failed(&file))?);
        }
        if self.without_solutions {
            withhold_solutions(&mut contents, chosen)?;
        }
        let workspace = contents.remove("Cargo.toml").unwrap_or_default();
        let workspace = String::from_utf8_lossy(&workspace).into_owned();
        let workspace = members_in(&workspace, &contents);
        contents.insert("Cargo.toml".to_owned(), workspace.into());
        let last = chosen.last().map_or("", |e| e.stage);
        let readme = README.replace("{stage}", last);
        contents.insert("README.md".to_owned(), readme.into());
        Ok(contents)
    }
}

/// Leaves out the folders of solutions. The starters of their exercises come into the folder of
/// starters without a solution, whose checks are not proved.
fn withhold_solutions(
    contents: &mut BTreeMap<String, Vec<u8>>,
    chosen: &[Exercise],
) -> Result<(), String> {
    for e in chosen {
        let path = |folder| format!("{}/exercises/{folder}/{}.rs", e.stage, e.name);
        if contents.remove(&path("solutions")).is_some() {
            contents.remove(&path("starters"));
            contents.insert(path(files::OPEN), files::starter(e)?.into());
        }
    }
    Ok(())
}

/// The manifest of the workspace without the members and the profiles of stages that are not
/// handed out.
fn members_in(workspace: &str, contents: &BTreeMap<String, Vec<u8>>) -> String {
    let has = |folder: &str| contents.keys().any(|path| path.starts_with(folder));
    let is_there = |line: &&str| match line.split(['"', '.']).collect::<Vec<_>>()[..] {
        ["    ", member, ","] => has(&format!("{member}/Cargo.toml")),
        [package, level] if package.starts_with("a0") && level.starts_with("opt-level") => {
            has(&package[..3])
        }
        _ => true,
    };
    let lines: Vec<_> = workspace.lines().filter(is_there).collect();
    lines.join("\n") + "\n"
}

/// The output of a program that must succeed.
fn output_of(program: &mut Command) -> Result<Vec<u8>, String> {
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
        if !files::workspace().join(".git").exists() {
            eprintln!("skipped: a handout is written by a workbook in Git");
            return;
        }
        let course = crate::exercise::read_all().unwrap();
        let handout = Handout {
            without_solutions: true,
            ..Handout::default()
        };
        let contents = handout.contents(course, course).unwrap();
        let is_read = |path: &str| {
            assert!(!path.contains("/solutions/"), "{path}");
            // A check has code for mistakes, which may share a line with the solution.
            let is_check = path.contains("/tests/");
            path.contains("/exercises/") && !is_check || path.starts_with("book/src/a")
        };
        let of_stages = contents.iter().filter(|(path, _)| is_read(path));
        let texts = of_stages.map(|(_, bytes)| String::from_utf8_lossy(bytes));
        let text: String = texts.collect();
        let starters: String = course.iter().map(|e| files::starter(e).unwrap()).collect();
        let mut searched = 0;
        for e in course {
            let solution = format!("{}/exercises/solutions/{}.rs", e.stage, e.name);
            let Ok(solution) = files::read(&solution) else {
                continue;
            };
            // A shorter line, such as a brace, says nothing.
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
