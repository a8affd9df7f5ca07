//! `GradingFolder`: a folder in which one file after the other is compiled and judged.
//!
//! Each grading that runs at the same time has its own: `target/grading/1`, `2` and so on. They remain,
//! so that the next grading has nothing to build.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use learn::exercise::Exercise;
use learn::files::{self, with_path};

use crate::sandbox::{End, Ended, Limits, Sandbox};

/// The name of the file that says that everything is built.
const BUILT: &str = "built";

/// The files of a workbook by their paths.
pub type Workbook = BTreeMap<String, Vec<u8>>;

/// A folder that no other grading uses.
pub struct GradingFolder {
    pub sandbox: Sandbox,
    /// The lock, which ends with the program.
    _lock: File,
}

impl GradingFolder {
    /// The first folder that nobody uses.
    pub fn take() -> Result<Self, String> {
        let all = all_folders();
        for number in 1.. {
            let folder = all.join(number.to_string());
            fs::create_dir_all(&folder).map_err(with_path(&folder))?;
            let path = folder.join("lock");
            let lock = File::create(&path).map_err(with_path(&path))?;
            match lock.try_lock() {
                Ok(()) => {
                    return Ok(Self {
                        sandbox: Sandbox { folder },
                        _lock: lock,
                    });
                }
                Err(fs::TryLockError::WouldBlock) => {}
                Err(fs::TryLockError::Error(error)) => return Err(with_path(&path)(error)),
            }
        }
        Err("there is no free folder".to_owned())
    }

    fn folder(&self) -> &Path {
        &self.sandbox.folder
    }

    /// The place of a file in its workbook.
    fn in_workbook(&self, path: &str) -> PathBuf {
        self.folder().join("workbook").join(path)
    }

    /// Writes what has changed of the workbook, and builds the stages of the exercises. One folder is built at
    /// a time; a new one begins with a copy of what another one has built.
    pub fn prepare(&self, workbook: &Workbook, exercises: &[&Exercise]) -> Result<(), String> {
        let path = all_folders().join("lock");
        let building = File::create(&path).map_err(with_path(&path))?;
        building.lock().map_err(with_path(&path))?;
        let root = self.in_workbook("");
        fs::create_dir_all(&root).map_err(with_path(&root))?;
        update(&root, workbook).map_err(with_path(&root))?;
        // Cargo forgets the packages that the handout does not need.
        let mut cargo = Command::new("cargo");
        cargo.args(["update", "--workspace", "--offline", "--quiet"]);
        output_of(cargo.current_dir(&root))?;
        let target = self.folder().join("target");
        if !target.exists() {
            self.copy_target_of_another();
        }
        fs::create_dir_all(&target).map_err(with_path(&target))?;
        for e in exercises.chunk_by(|a, b| a.stage == b.stage) {
            self.build_stage(e[0])?;
        }
        let built = self.folder().join(BUILT);
        fs::write(&built, "").map_err(with_path(&built))
    }

    /// Builds a stage by the words by which its students' files are built, so that for each of them
    /// only the file itself is compiled within the student's limit of time.
    fn build_stage(&self, e: &Exercise) -> Result<(), String> {
        let built = self.build(e, &files::starter(e)?, Limits::All)?;
        if built.end == End::Success {
            return Ok(());
        }
        Err(format!("{} does not build\n{}", e.stage, built.output))
    }

    /// Builds the program of an exercise with a file, which is there only meanwhile: the next one
    /// shall not find it.
    pub fn build(&self, e: &Exercise, text: &str, limits: Limits) -> Result<Ended, String> {
        let file = self.in_workbook(&format!("{}/exercises/{}.rs", e.stage, e.name));
        fs::write(&file, text).map_err(with_path(&file))?;
        let mut build = ["cargo", "--offline", "--quiet"]
            .map(str::to_owned)
            .to_vec();
        build.extend(learn::arguments(e));
        let built = self.sandbox.run(limits, build);
        fs::remove_file(&file).map_err(with_path(&file))?;
        built
    }

    /// If another folder is built, copies its `target`. Its files of the last student may vanish
    /// meanwhile; Cargo builds what is missing.
    fn copy_target_of_another(&self) {
        for entry in fs::read_dir(all_folders()).into_iter().flatten().flatten() {
            if entry.path().join(BUILT).exists() {
                let mut copy = Command::new("cp");
                copy.args(["-a", "--reflink=auto"]);
                copy.arg(entry.path().join("target")).arg(self.folder());
                let _ = copy.output();
                return;
            }
        }
    }
}

/// The folder of all folders.
fn all_folders() -> PathBuf {
    files::workspace().join("target/grading")
}

/// Writes the files that differ, and removes those that are in no workbook: of others Cargo sees by
/// their times that they are built.
fn update(root: &Path, workbook: &Workbook) -> io::Result<()> {
    for path in paths_in(root, root)? {
        if !workbook.contains_key(&path) {
            fs::remove_file(root.join(&path))?;
        }
    }
    for (path, bytes) in workbook {
        let file = root.join(path);
        if fs::read(&file).is_ok_and(|old| old == *bytes) {
            continue;
        }
        if let Some(folder) = file.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(&file, bytes)?;
    }
    Ok(())
}

/// The paths of all files below a folder, from the root, with `/`.
fn paths_in(root: &Path, folder: &Path) -> io::Result<Vec<String>> {
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

/// The output of a program that must succeed.
pub fn output_of(program: &mut Command) -> Result<Vec<u8>, String> {
    let name = program.get_program().to_owned();
    let output = program.output().map_err(with_path(name.as_ref()))?;
    if output.status.success() {
        return Ok(output.stdout);
    }
    let problem = [output.stdout, output.stderr].concat();
    Err(String::from_utf8_lossy(&problem).into_owned())
}
