//! `program`: writes a program outside of the workbook, with the student's functions in it and, until
//! they are done, those of the solutions.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use common::text;

use crate::exercise::Exercise;
use crate::files::{self, with_path};
use crate::progress::Progress;

/// The files of the program without its functions, which are in the files of exercises.
const FILES: [(&str, &str); 7] = [
    ("functions", include_str!("../program/src/functions.rs")),
    ("lights", include_str!("../program/src/lights.rs")),
    ("main", include_str!("../program/src/main.rs")),
    ("materials", include_str!("../program/src/materials.rs")),
    ("mesh", include_str!("../program/src/mesh.rs")),
    ("prelude", include_str!("../program/src/prelude.rs")),
    ("transform", include_str!("../program/src/transform.rs")),
];

/// The manifest, with `{workbook}` instead of its folder, and the names of two libraries in braces
/// instead of their lines in the workbook's manifest.
const MANIFEST: &str = include_str!("../program/Cargo.toml");

/// Writes a program of your own, with your functions in it
#[derive(clap::Args)]
pub struct Program {
    /// A new folder
    folder: PathBuf,
}

/// Texts of files, by their paths or names.
type Files = BTreeMap<String, String>;

impl Program {
    /// Writes the program into a new or empty folder, and returns what is in it.
    pub fn run(&self, course: &[Exercise]) -> Result<String, String> {
        let folder = &self.folder;
        let shown = text::path(folder);
        let is_taken = fs::read_dir(folder).is_ok_and(|mut folder| folder.next().is_some());
        if is_taken || folder.is_file() {
            return Err(format!(
                "{shown} is there already, and is left as it is; a program needs a new folder"
            ));
        }
        let progress = Progress::read();
        let (mut yours, mut others) = (Files::new(), Vec::new());
        for e in course.iter().filter(|e| functions().contains(&e.name)) {
            if progress.is_done(e) {
                let path = files::yours(e);
                let text = fs::read_to_string(&path).map_err(with_path(&path))?;
                yours.insert(e.name.to_owned(), text);
            } else {
                let is_begun = files::is_begun(e);
                let mark = if is_begun { " (begun)" } else { "" };
                others.push(format!("{}{mark}", e.name));
            }
        }
        if yours.is_empty() {
            let names = others.join(", ");
            return Err(format!(
                "none of the functions that the program calls is done: {names}; `cargo learn` shows the \
                 next exercise"
            ));
        }
        write(folder, &program(&yours)?)?;
        let names: Vec<_> = yours.into_keys().collect();
        let mut lines = vec![format!(
            "{shown}: your program, with your {}",
            names.join(", ")
        )];
        if !others.is_empty() {
            let names = others.join(", ");
            lines.push(format!("not done, and so the workbook's: {names}"));
        }
        lines.push(format!(
            "begin with {}",
            text::path(&folder.join("src/main.rs"))
        ));
        let quoted = if shown.contains(' ') {
            format!("\"{shown}\"")
        } else {
            shown
        };
        lines.push(format!("draw its scene: cd {quoted} && cargo run"));
        Ok(lines.join("\n"))
    }
}

/// The exercises whose functions the program calls.
fn functions() -> Vec<&'static str> {
    let (_, functions) = FILES[0];
    let names = functions
        .lines()
        .filter_map(|line| line.strip_prefix("pub mod "));
    names.map(|name| name.trim_end_matches(';')).collect()
}

/// The files of the program with these functions of the student instead of the workbook's.
fn program(yours: &Files) -> Result<Files, String> {
    let mut program = Files::new();
    for (name, text) in FILES {
        program.insert(format!("src/{name}.rs"), text.to_owned());
    }
    for name in functions() {
        let text = if let Some(text) = yours.get(name) {
            without_examples(text)
        } else {
            let Ok(e) = crate::exercise::find(name) else {
                return Err("the program needs all stages, and this workbook lacks some".to_owned());
            };
            let solution = format!("{}/exercises/solutions/{name}.rs", e.stage);
            without_examples(&files::read(&solution)?)
        };
        program.insert(format!("src/functions/{name}.rs"), text);
    }
    program.insert("Cargo.toml".to_owned(), manifest()?);
    // The same versions of all libraries, which are there without a network.
    program.insert("Cargo.lock".to_owned(), files::read("Cargo.lock")?);
    program.insert(".gitignore".to_owned(), "/target\n".to_owned());
    Ok(program)
}

/// A student's file without the examples, which need the check.
fn without_examples(text: &str) -> String {
    let mut kept = Vec::new();
    let mut is_example = false;
    for line in text.lines() {
        is_example |= line.starts_with("testing::examples!");
        if !is_example {
            kept.push(line);
        }
        is_example &= line != "}";
    }
    kept.join("\n").trim_end().to_owned() + "\n"
}

fn manifest() -> Result<String, String> {
    let workspace = files::workspace();
    let Some(folder) = workspace.to_str().filter(|folder| !folder.contains('"')) else {
        let folder = text::path(&workspace);
        return Err(format!("{folder} cannot be written into a manifest"));
    };
    // Windows takes these, too.
    let mut manifest = MANIFEST.replace("{workbook}", &folder.replace('\\', "/"));
    for line in files::read("Cargo.toml")?.lines() {
        for library in ["glam", "libm"] {
            if line.starts_with(&format!("{library} = ")) {
                manifest = manifest.replace(&format!("{{{library}}}"), line);
            }
        }
    }
    Ok(manifest)
}

fn write(folder: &Path, program: &Files) -> Result<(), String> {
    for (name, text) in program {
        let path = folder.join(name);
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(with_path(folder))?;
        }
        fs::write(&path, text).map_err(with_path(&path))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    use super::*;

    /// A handout may lack the stages above.
    fn is_whole() -> bool {
        let is_whole = crate::exercise::find("disc").is_ok();
        if !is_whole {
            eprintln!("skipped: this workbook lacks the stage of the program");
        }
        is_whole
    }

    /// Of each function there is an exercise of the core path.
    #[test]
    fn functions_are_exercises() {
        if !is_whole() {
            return;
        }
        for name in functions() {
            let e = crate::exercise::find(name).unwrap();
            assert!(e.is_core, "{name}");
        }
    }

    #[test]
    fn examples_are_left_out() {
        let text = "use a;\n\ntesting::examples! {\n    f();\n}\n\nfn g() {\n}\n";
        assert_eq!(without_examples(text), "use a;\n\n\nfn g() {\n}\n");
        assert_eq!(
            without_examples("use a;\ntesting::examples! {}"),
            "use a;\n"
        );
        assert_eq!(without_examples("use a;"), "use a;\n");
    }

    /// A program with a plane of a student draws its scene, outside of the workbook.
    #[test]
    fn the_program_draws_its_scene() {
        if !is_whole() {
            return;
        }
        let plane = crate::exercise::find("plane").unwrap();
        let starter = files::starter(plane).unwrap();
        let code = "let d = ray.direction().dot(self.n);\n        \
                    let t = (self.a - ray.origin()).dot(self.n) / d;\n        \
                    within.contains(t).then(|| Hit::new(t, self.n))";
        let missing = "testing::missing(\"the hit within the interval\", None)";
        assert!(starter.contains(missing));
        let yours = starter.replace(missing, code);
        let yours = Files::from([("plane".to_owned(), yours)]);
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let mut program = program(&yours).unwrap();
        // Soon built: libraries from outside as for the workbook, and the rest not optimised.
        let manifest = program.get_mut("Cargo.toml").unwrap();
        let quick = manifest
            .lines()
            .map(|line| match line.split_once(".opt-level") {
                Some((name, _)) if files::workspace().join(name).is_dir() || name == "engine" => "",
                _ => line,
            });
        *manifest = quick
            .collect::<Vec<_>>()
            .join("\n")
            .replace("opt-level = 3", "opt-level = 0");
        let main = program.get_mut("src/main.rs").unwrap();
        *main = main
            .replace("[480, 320]", "[48, 32]")
            .replace("SAMPLES: u32 = 16", "SAMPLES: u32 = 1");
        write(folder, &program).unwrap();

        let mut cargo = Command::new("cargo");
        cargo.env("CARGO_TARGET_DIR", files::workspace().join("target"));
        cargo.args(["run", "--offline"]).current_dir(folder);
        let output = cargo.output().unwrap();
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{errors}");
        assert!(!errors.contains("warning"), "{errors}");
        assert_eq!(output.stdout, b"picture.png\n");
        let picture = common::picture_file::open(&folder.join("picture.png")).unwrap();
        assert_eq!(picture.size(), common::Size::new(48, 32).unwrap());
        assert!(
            picture
                .pixels()
                .iter()
                .any(|color| color.channels()[0] > 0.8)
        );
    }
}
