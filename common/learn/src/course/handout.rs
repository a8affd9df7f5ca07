//! `handout`: the workbook up to a stage, on request without solutions, whose answers its
//! checks then read from records.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command as Process;

use clap::{Arg, ArgAction, ArgMatches, Command};

use super::{exercises, failed, stages, until};
use crate::exercise::Exercise;
use crate::{files, judgement};

/// The page for students, with `{stage}` in the place of the last stage.
const README: &str = include_str!("../../handout/README.md");

/// What Git has of the workbook, without the stages and their pages.
const PARTS: &str = ".cargo .gitignore Cargo.lock Cargo.toml LICENSE clippy.toml common";

pub fn command() -> Command {
    let folder = Arg::new("folder").value_name("FOLDER").required(true);
    let bare = Arg::new("without-solutions").long("without-solutions");
    let bare = bare.action(ArgAction::SetTrue);
    Command::new("handout")
        .about("For lecturers: writes a workbook for students")
        .arg(folder.help("A new folder"))
        .arg(until())
        .arg(bare.help("Leaves out the solutions that are no lessons, and the proofs of checks"))
}

/// Writes the handout of a command line, and returns what it has.
pub fn run(course: &'static [Exercise], matches: &ArgMatches) -> Result<String, String> {
    let chosen = exercises(course, matches)?;
    let folder = matches.get_one::<String>("folder");
    let folder = folder.map_or("", |folder| folder);
    let is_bare = matches.get_flag("without-solutions");
    write(Path::new(folder), &chosen, is_bare)?;
    let count = chosen.len();
    Ok(format!(
        "{folder}: {count} exercises; test it: cargo test --workspace"
    ))
}

/// Writes a handout into a new or empty folder.
pub fn write(folder: &Path, chosen: &[&Exercise], is_bare: bool) -> Result<(), String> {
    if fs::read_dir(folder).is_ok_and(|mut folder| folder.next().is_some()) {
        let path = folder.display();
        return Err(format!("{path} is not empty; a handout needs a new folder"));
    }
    let mut contents = contents(chosen, is_bare)?;
    for e in chosen.iter().filter(|e| is_bare && !e.is_core) {
        let mut proofs = Process::new(judgement::proofs(e.stage)?);
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
    let mut cargo = Process::new("cargo");
    cargo.args(["metadata", "--format-version=1", "--quiet"]);
    said(cargo.current_dir(folder)).map(drop)
}

/// The output of a program that must succeed.
fn said(program: &mut Process) -> Result<Vec<u8>, String> {
    let name = program.get_program().to_owned();
    let output = program.output().map_err(failed(name.as_ref()))?;
    if output.status.success() {
        return Ok(output.stdout);
    }
    let problem = [output.stdout, output.stderr].concat();
    Err(String::from_utf8_lossy(&problem).into_owned())
}

/// The files of a handout by their paths, without records.
fn contents(chosen: &[&Exercise], is_bare: bool) -> Result<BTreeMap<String, Vec<u8>>, String> {
    let stages = stages(chosen);
    let pages = stages.iter().flat_map(|stage| {
        let pages = format!("book/src/{}-*", &stage[..3]);
        [
            stage.to_string(),
            pages,
            format!("book/src/pictures/{stage}*"),
        ]
    });
    let mut git = Process::new("git");
    git.args("ls-files -z --cached --others --exclude-standard".split(' '));
    let parts = PARTS.split(' ').map(str::to_owned).chain(pages);
    let paths = said(git.args(parts).current_dir(files::workspace()))?;
    let paths = String::from_utf8_lossy(&paths).into_owned();
    let is_kept = |path: &&str| !path.contains("/tests/") || path.contains("/tests/exercises/");

    let mut contents = BTreeMap::new();
    for path in paths.split_terminator('\0').filter(is_kept) {
        let file = files::workspace().join(path);
        contents.insert(path.to_owned(), fs::read(&file).map_err(failed(&file))?);
    }
    for e in chosen.iter().filter(|e| is_bare && !e.is_core) {
        let solution = format!("{}/exercises/solutions/{}.rs", e.stage, e.name);
        contents.insert(solution, files::starter(e)?.into());
        // The proofs are the end of the file.
        let path = format!("{}/tests/exercises/{}.rs", e.stage, e.name);
        let check = files::read(&path)?;
        let check = check.split("\nvariants! {").next().unwrap_or_default();
        let none = "pub const VARIANTS: &[Variant] = &[];";
        contents.insert(path, format!("#![allow(unused)]\n{check}\n{none}\n").into());
    }
    let is_there = |line: &&str| {
        let member = line.trim().strip_prefix('"');
        let member = member.and_then(|line| line.strip_suffix("\","));
        member.is_none_or(|member| contents.contains_key(&format!("{member}/Cargo.toml")))
    };
    let workspace = files::read("Cargo.toml")?;
    let workspace: Vec<_> = workspace.lines().filter(is_there).collect();
    contents.insert("Cargo.toml".to_owned(), workspace.join("\n").into());
    let readme = README.replace("{stage}", stages.last().unwrap_or(&""));
    contents.insert("README.md".to_owned(), readme.into());
    Ok(contents)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_handout_has_no_line_of_a_solution() {
        let course = crate::exercise::read_all().unwrap();
        let course: Vec<_> = course.iter().collect();
        let files = contents(&course, true).unwrap();
        let starters: String = course.iter().map(|e| files::starter(e).unwrap()).collect();
        let is_read = |path: &str| path.contains("/exercises/") || path.starts_with("book/src/a");
        let of_stages = files.iter().filter(|(path, _)| is_read(path));
        let text: Vec<u8> = of_stages.flat_map(|(_, bytes)| bytes.clone()).collect();
        let text = String::from_utf8(text).unwrap();
        let mut searched = 0;
        for e in course.iter().filter(|e| !e.is_core) {
            let solution = files::read(&format!("{}/exercises/solutions/{}.rs", e.stage, e.name));
            // A shorter line, as a brace, says nothing.
            let is_own = |line: &&str| line.len() > 24 && !line.contains("missing!(");
            for line in solution.unwrap().lines().map(str::trim).filter(is_own) {
                if !starters.contains(line) {
                    searched += 1;
                    assert!(!text.contains(line), "{line} of {}", e.name);
                }
            }
        }
        assert!(searched > 100, "{searched} lines of solutions");
    }
}
