//! `handout`: the workbook up to a stage, as far as its exercises need it: the packages that they are built of, without
//! tests, and the pages of its stages. On request without solutions: checks need no more than the recorded answers.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};

use learn::exercise::Exercise;
use learn::files::{self, with_path};
use learn::{sheet, starter};

use crate::packages::{Package, Packages};
use crate::program_output::output_of;
use crate::stages::exercises_until;

/// The files of a workbook by their paths.
pub type Workbook = BTreeMap<String, Vec<u8>>;

/// The page for students, with `{stage}` instead of the last stage.
const README: &str = include_str!("../handout/README.md");

/// The commands of students, by which a handout is known.
const CONFIG_FILE: &str = ".cargo/config.toml";
const CONFIG: &str = "[alias]\nlearn = \"run --package learn --\"\n";

/// The files that are handed out and belong to no package.
const ROOT: [&str; 5] = [
    ".gitignore",
    "Cargo.lock",
    "Cargo.toml",
    "LICENSE",
    "clippy.toml",
];

/// The files and folders of a package that exercises are built of, as far as it has them.
const BUILT: [&str; 11] = [
    "Cargo.toml",
    "assets/",
    "build.rs",
    "cases.toml",
    "exercises/answers/",
    "exercises/exercises.toml",
    "exercises/solutions/",
    "scenes/",
    "single.toml",
    "src/",
    "tests/exercises/",
];

/// The pages of the book, and their pictures.
const BOOK: &str = "book/src/";

/// The open sheets.
const SHEETS: &str = "common/judge/sheets/";

/// Writes a workbook for students
#[derive(clap::Args, Default)]
pub struct Handout {
    /// A new folder
    pub folder: PathBuf,
    /// Brings the next stage into the handout of an earlier week; exercises and other files in it stay
    #[arg(long)]
    pub into: bool,
    /// The last stage, such as a04 [default: all stages]
    #[arg(long, value_name = "STAGE")]
    pub until: Option<String>,
    /// Leaves out the solutions that are no lessons
    #[arg(long)]
    pub without_solutions: bool,
}

impl Handout {
    /// Writes the handout, and returns what it has.
    pub fn run(&self, course: &'static [Exercise]) -> Result<String, String> {
        let folder = &self.folder;
        let shown = folder.display();
        let is_handout =
            fs::read(folder.join(CONFIG_FILE)).is_ok_and(|file| file == CONFIG.as_bytes());
        let is_empty = fs::read_dir(folder).is_ok_and(|mut folder| folder.next().is_none());
        if self.into && !is_handout {
            return Err(format!(
                "{shown} is no handout; without --into, one is made in a new folder"
            ));
        }
        if folder.exists() && !is_empty && !self.into {
            return Err(format!(
                "{shown} is not empty; a handout needs a new folder, and --into brings an earlier one up to date"
            ));
        }
        let mut files = self.workbook(course)?;
        fs::create_dir_all(folder).map_err(with_path(folder))?;
        files.extend(built_book()?);
        for (path, bytes) in &files {
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
        let count = exercises_until(course, self.until.as_ref())?.len();
        Ok(format!("{shown}: {count} exercises; test it: cargo learn"))
    }

    /// The files of the workbook.
    pub fn workbook(&self, course: &'static [Exercise]) -> Result<Workbook, String> {
        let chosen = exercises_until(course, self.until.as_ref())?;
        let mut built: Vec<_> = chosen.iter().map(|e| e.stage).collect();
        built.push("learn");
        let Packages { needed, others } = Packages::read(&built)?;
        let is_built = |path: &str| {
            let within = needed
                .iter()
                .filter_map(|of| path.strip_prefix(&*of.folder));
            let mut within = within.filter_map(|inner| inner.strip_prefix('/'));
            within.any(|inner| BUILT.iter().any(|of| inner.starts_with(of)))
        };
        let paths = paths()?;
        let pages = pages(&paths, &course[chosen.len()..])?;
        let mut workbook = Workbook::new();
        for path in &paths {
            if pages.contains(&**path) || ROOT.contains(&&**path) || is_built(path) {
                let file = files::workspace().join(path);
                let bytes = fs::read(&file).map_err(with_path(&file))?;
                workbook.insert(path.clone(), bytes);
            }
        }
        if self.without_solutions {
            withhold_solutions(&mut workbook, chosen)?;
        }
        for (path, bytes) in &mut workbook {
            if path.ends_with("Cargo.toml") {
                *bytes = without_packages(&String::from_utf8_lossy(bytes), &others).into();
            }
        }
        workbook.insert(CONFIG_FILE.to_owned(), CONFIG.into());
        let last = chosen.last().map_or("", |e| e.stage);
        let readme = README.replace("{stage}", last);
        workbook.insert("README.md".to_owned(), readme.into());
        Ok(workbook)
    }
}

/// The files of the book as it is read. All of it is handed out, so that no link is dead.
fn built_book() -> Result<Workbook, String> {
    let mut cargo = Command::new("cargo");
    let status = cargo.arg("book").current_dir(files::workspace()).status();
    if !status.map_err(with_path("cargo".as_ref()))?.success() {
        return Err("the book is not built, and so nothing is handed out".to_owned());
    }
    let root = files::workspace().join("target/book");
    let mut book = Workbook::new();
    for path in paths_in(&root, &root).map_err(with_path(&root))? {
        let file = root.join(&path);
        book.insert(
            format!("book/{path}"),
            fs::read(&file).map_err(with_path(&file))?,
        );
    }
    Ok(book)
}

/// The paths of all files below a folder, from the root, with `/`.
pub fn paths_in(root: &Path, folder: &Path) -> io::Result<Vec<String>> {
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            paths.extend(paths_in(root, &path)?);
        } else {
            let path = path.strip_prefix(root).unwrap_or(&path);
            paths.push(path.to_string_lossy().into_owned());
        }
    }
    Ok(paths)
}

/// The paths of all files that Git does not ignore.
fn paths() -> Result<Vec<String>, String> {
    let mut git = Command::new("git");
    git.args([
        "ls-files",
        "-z",
        "--cached",
        "--others",
        "--exclude-standard",
    ]);
    let paths = output_of(git.current_dir(files::workspace()))?;
    let paths = String::from_utf8_lossy(&paths);
    Ok(paths.split_terminator('\0').map(str::to_owned).collect())
}

/// What checks and `cargo learn` read: the pages of exercises, the pictures of these pages and of scenes, and the sheets
/// that the stages open. Names of pages and pictures begin with that of the stage.
fn pages<'a>(paths: &'a [String], above: &[Exercise]) -> Result<BTreeSet<&'a str>, String> {
    let is_handed_out = |name: &str| {
        let stage = name.split_once('-').map_or("", |(stage, _)| stage);
        stage.starts_with("a0") && !above.iter().any(|e| e.stage.starts_with(stage))
    };
    let mut sheets = sheet::read_all()?;
    sheets.retain(|sheet| !above.iter().any(|e| e.stage == sheet.stage));
    let sheets: Vec<_> = sheets
        .iter()
        .map(|sheet| format!("{SHEETS}{}.toml", sheet.name))
        .collect();
    let mut pages = BTreeSet::new();
    let mut text = String::new();
    for path in paths {
        let name = path.strip_prefix(BOOK).unwrap_or_default();
        let is_page = name.ends_with("-exercises.md") && is_handed_out(name);
        if is_page || sheets.contains(path) {
            pages.insert(&**path);
            text += &files::read(path)?;
        }
    }
    for path in paths {
        let name = path.strip_prefix(BOOK).unwrap_or_default();
        let is_scene = name.strip_prefix("pictures/").is_some_and(is_handed_out);
        if name.contains('/') && (is_scene || text.contains(name)) {
            pages.insert(&**path);
        }
    }
    Ok(pages)
}

/// Replaces solutions that are no lessons by their starters, which are not proved.
fn withhold_solutions(workbook: &mut Workbook, chosen: &[Exercise]) -> Result<(), String> {
    for e in chosen.iter().filter(|e| !e.is_core) {
        let path = format!("{}/exercises/solutions/{}.rs", e.stage, e.name);
        workbook.insert(path, starter(e)?.into());
    }
    Ok(())
}

/// A manifest without the lines about packages that are not handed out: as members, as libraries of tests, and in
/// profiles.
fn without_packages(manifest: &str, absent: &[Package]) -> String {
    let mut text = String::new();
    for line in manifest.lines() {
        let first = line.split([' ', '.']).next();
        let member = line.trim().trim_end_matches(',').trim_matches('"');
        let is_absent = |of: &Package| first == Some(&*of.name) || member == of.folder;
        if !absent.iter().any(is_absent) {
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
            let starter = starter(e).unwrap();
            assert_eq!(contents[&path], starter.into_bytes(), "{}", e.name);
        }
        for path in contents.keys() {
            assert!(!path.starts_with("common/course/"), "{path}");
            assert!(!path.contains("/exercises/others/"), "{path}");
        }
    }

    #[test]
    fn a_handout_has_the_sheets_that_its_stages_open() {
        if !files::workspace().join(".git").exists() {
            eprintln!("skipped: a handout is written by a workbook in Git");
            return;
        }
        let course = learn::exercise::read_all().unwrap();
        for (stage, sheet, is_there) in [
            ("a02", "lens", false),
            ("a03", "lens", true),
            ("a03", "tree", false),
            ("a04", "tree", true),
        ] {
            let handout = Handout {
                until: Some(stage.to_owned()),
                ..Handout::default()
            };
            let contents = handout.workbook(course).unwrap();
            let path = format!("{SHEETS}{sheet}.toml");
            assert_eq!(contents.contains_key(&path), is_there, "{stage}: {path}");
        }
    }
}
