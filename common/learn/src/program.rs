//! `program`: brings the functions of exercises into a program of the student's, outside of the workbook.
//!
//! The student has made the program by `cargo new`, and its `main.rs` is theirs: nothing here writes it.
//! Its file `functions.rs` is written anew each time; a file in `functions` only as long as the student has
//! not edited it there.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use common::text;

use crate::exercise::Exercise;
use crate::files::{self, with_path};
use crate::progress::Progress;

/// Exercises whose functions take types that only their checks have.
const LEFT_OUT: [&str; 2] = ["chain", "stripe"];

/// The stage of `mirror`, whose `trace` asks a tracer which lights reach a hit. This one calls the student's
/// `is_shadowed`.
const STAGE_OF_TRACER: &str = "a06-shadows-reflection";
const TRACER: &str = include_str!("program/recursive_tracer.rs");

/// The beginning of `functions.rs`.
const BEGINNING: &str = "\
//! Your functions. `cargo learn program` writes this file anew; of an exercise that is open, it takes the
//! workbook's function. Types such as `Image` are the workbook's, unless a file in `functions` defines them.

#![allow(unused, reason = \"a program calls the functions that it needs\")]

/// In a function of the workbook, the code that an exercise asks for.
macro_rules! missing {
    ($what:expr, $for_now:expr, $code:expr) => {
        $code
    };
}

pub use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_6, PI, TAU};

pub use common::*;
";

const MANIFEST: &str = "Cargo.toml";
const DEPENDENCIES: &str = "[dependencies]\n";

/// Added to a manifest without a profile: what draws is optimised, so that pictures take seconds; other
/// libraries stay as they are built.
const PROFILE: &str = "
[profile.dev]
opt-level = 3

[profile.dev.package.\"*\"]
opt-level = 0

[profile.dev.package.common]
opt-level = 3

[profile.dev.package.libm]
opt-level = 3
";

/// Brings your functions into a program of your own
#[derive(clap::Args)]
pub struct Program {
    /// The folder of the program, which `cargo new` has made
    folder: PathBuf,
}

impl Program {
    /// Brings the functions into the program, and returns which of them are the student's.
    pub fn run(&self, course: &[Exercise]) -> Result<String, String> {
        let folder = &self.folder;
        let shown = text::path(folder);
        if !folder.join(MANIFEST).is_file() {
            return Err(format!(
                "{shown} has no {MANIFEST}: `cargo new {shown}` begins a program, and this brings your functions into it"
            ));
        }
        let progress = Progress::read();
        let mut done = BTreeMap::new();
        for e in course.iter().filter(|e| progress.is_done(e)) {
            done.insert(e.name, files::text_of(&files::yours(e))?);
        }
        let brought = bring(folder, course, &done)?;
        let mut lines = vec![format!("{shown}: your {}", brought.yours.join(", "))];
        for (words, names) in [
            ("open, and so the workbook's", &brought.workbooks),
            ("edited there, and so left as they are", &brought.edited),
        ] {
            if !names.is_empty() {
                lines.push(format!("{words}: {}", names.join(", ")));
            }
        }
        let main = folder.join("src/main.rs");
        if !fs::read_to_string(&main).is_ok_and(|main| main.contains("mod functions;")) {
            let main = text::path(&main);
            lines.push(format!(
                "{main} calls them after the lines: mod functions; use functions::*;"
            ));
        }
        Ok(lines.join("\n"))
    }
}

/// The names of exercises by what has become of their files.
#[derive(Default)]
struct Brought {
    yours: Vec<&'static str>,
    workbooks: Vec<&'static str>,
    edited: Vec<&'static str>,
}

/// Writes the functions of all stages up to the last one in which an exercise of the core path is
/// done: the texts that are `done`, by the names of their exercises, and the workbook's.
fn bring(
    folder: &Path,
    course: &[Exercise],
    done: &BTreeMap<&str, String>,
) -> Result<Brought, String> {
    let is_done = |e: &&Exercise| e.is_core && done.contains_key(e.name);
    let Some(last) = course.iter().rfind(is_done) else {
        return Err(
            "no exercise of the core path is done; `cargo learn` shows the next".to_owned(),
        );
    };
    let mut stages: Vec<_> = course.iter().map(|e| e.stage).collect();
    stages.dedup();
    stages.retain(|stage| *stage <= last.stage);
    let mut functions = BEGINNING.to_owned();
    // Pixels need nothing but `common`.
    let libraries = &stages[1..];
    for stage in libraries {
        let library = stage.replace('-', "_");
        functions.extend(["pub use ", &library, "::*;\n"]);
    }
    let mut brought = Brought::default();
    for e in course {
        if !e.is_core || !stages.contains(&e.stage) || LEFT_OUT.contains(&e.name) {
            continue;
        }
        let solution = format!("{}/exercises/solutions/{}.rs", e.stage, e.name);
        let workbooks = in_program(&files::read(&solution)?);
        let yours = done.get(e.name).map(|text| in_program(text));
        let text = yours.as_ref().unwrap_or(&workbooks);
        functions += &module(e.name, text);
        let names = if !write_unless_edited(folder, e.name, text, &workbooks)? {
            &mut brought.edited
        } else if yours.is_some() {
            &mut brought.yours
        } else {
            &mut brought.workbooks
        };
        names.push(e.name);
    }
    if stages.contains(&STAGE_OF_TRACER) {
        functions += &module("recursive_tracer", TRACER);
        write_unless_edited(folder, "recursive_tracer", TRACER, TRACER)?;
    }
    write(&folder.join("src/functions.rs"), &functions)?;
    add_libraries(folder, libraries)?;
    Ok(brought)
}

/// The text of an exercise's file in the program: without the examples, which need the check.
fn in_program(text: &str) -> String {
    let mut kept = Vec::new();
    let mut is_example = false;
    for line in text.lines() {
        is_example |= line.starts_with("testing::examples!");
        if !is_example {
            kept.push(line);
        }
        is_example &= line != "}";
    }
    let text = kept.join("\n").trim_end().to_owned() + "\n";
    text.replace("use crate::prelude::*;", "use super::*;")
}

/// The lines of `functions.rs` for a file: its public names replace those of the workbook.
fn module(name: &str, text: &str) -> String {
    let mut names = Vec::new();
    for line in text.lines() {
        let mut words = line.split(|c: char| !c.is_alphanumeric() && c != '_');
        if words.next() == Some("pub")
            && matches!(words.next(), Some("fn" | "struct" | "enum" | "const"))
        {
            names.extend(words.next());
        }
    }
    format!("\nmod {name};\npub use {name}::{{{}}};\n", names.join(", "))
}

/// Writes a file of a function, and returns whether it has: one that is neither this text nor the
/// workbook's has been edited there, and is left as it is.
fn write_unless_edited(
    folder: &Path,
    name: &str,
    text: &str,
    workbooks: &str,
) -> Result<bool, String> {
    let path = folder.join(format!("src/functions/{name}.rs"));
    let now = fs::read_to_string(&path);
    if now.is_ok_and(|now| now != text && now != workbooks) {
        return Ok(false);
    }
    write(&path, text)?;
    Ok(true)
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(with_path(folder))?;
    }
    fs::write(path, text).map_err(with_path(path))
}

/// Adds the stages to the manifest, where they are missing, and has them optimised.
fn add_libraries(folder: &Path, stages: &[&str]) -> Result<(), String> {
    if stages.is_empty() {
        return Ok(());
    }
    let path = folder.join(MANIFEST);
    let before = fs::read_to_string(&path).map_err(with_path(&path))?;
    if !before.contains(DEPENDENCIES) {
        return Err(format!("{} lacks a line [dependencies]", text::path(&path)));
    }
    let workspace = files::workspace();
    let Some(workbook) = workspace.to_str().filter(|path| !path.contains('"')) else {
        let workbook = text::path(&workspace);
        return Err(format!("{workbook} cannot be written into a manifest"));
    };
    // Windows takes this, too.
    let workbook = workbook.replace('\\', "/");
    let of_workbook = files::read("Cargo.toml")?;
    let libm = of_workbook.lines().find(|line| line.starts_with("libm = "));
    let mut dependencies: Vec<_> = libm.map(str::to_owned).into_iter().collect();
    let mut manifest = before.clone();
    if !before.contains("[profile.") {
        manifest += PROFILE;
    }
    for stage in stages {
        let path = format!("{workbook}/{stage}");
        dependencies.push(format!(
            "{stage} = {{ path = \"{path}\", default-features = false }}"
        ));
        if !before.contains(stage) {
            let optimised = format!("\n[profile.dev.package.{stage}]\nopt-level = 3\n");
            manifest += &optimised;
        }
    }
    for line in dependencies {
        let (name, _) = line.split_once('=').unwrap_or_default();
        if !before.contains(&format!("\n{name}=")) {
            let with_line = format!("{DEPENDENCIES}{line}\n");
            manifest = manifest.replacen(DEPENDENCIES, &with_line, 1);
        }
    }
    if manifest == before {
        return Ok(());
    }
    write(&path, &manifest)?;
    // The versions of libraries that the workbook is tested with, and has fetched.
    write(&folder.join("Cargo.lock"), &files::read("Cargo.lock")?)
}

#[cfg(test)]
mod tests {
    use std::process::Command;

    use common::{Color, picture_file};

    use super::*;
    use crate::exercise::{find, read_all};

    /// Libraries from outside are built as for the workbook, and nothing else is optimised: so it is
    /// soon built.
    const QUICK: &str = "[package]\nname = \"my-tracer\"\nedition = \"2024\"\n\n[dependencies]\n
[profile.dev]
codegen-units = 1
opt-level = 0
debug = false

[profile.dev.package]
jpeg-decoder.opt-level = 1
libm.opt-level = 3
png.opt-level = 2
toml_parser.opt-level = 1
";

    const PAGES: [&str; 8] = [
        "first-run",
        "a01-image-display",
        "a02-math",
        "a03-rays-cameras",
        "a04-intersections",
        "a05-lighting",
        "a06-shadows-reflection",
        "a07-transforms",
    ];

    /// The parts of the last listing of a program on a page of the book, which empty lines set apart,
    /// by their first lines of code: a later part replaces an earlier one.
    fn parts(page: &str) -> BTreeMap<String, String> {
        let text = files::read(&format!("book/src/{page}.md")).unwrap();
        let heading = if page == "first-run" {
            "## 3. Your first picture"
        } else {
            "## Your tracer tonight"
        };
        let (_, section) = text.split_once(heading).unwrap();
        let (_, listing) = section.split_once("```rust,ignore\n").unwrap();
        let (listing, _) = listing.split_once("```").unwrap();
        let mut parts = BTreeMap::new();
        for part in listing.split("\n\n") {
            let is_code = |line: &&str| !line.starts_with(['/', '#']);
            let first = part.lines().find(is_code).unwrap_or_default();
            parts.insert(first.to_owned(), part.to_owned());
        }
        parts
    }

    /// The picture of each page, by the program as it is there: modules of one program, which is
    /// built once.
    #[test]
    fn the_program_of_the_book_draws_a_picture_on_each_page() {
        let course = read_all().unwrap();
        if find("disc").is_err() {
            eprintln!("skipped: this workbook lacks the stage of the last page");
            return;
        }
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let common = files::workspace().join("common");
        let common = format!("[dependencies]\ncommon = {{ path = {common:?} }}\n");
        write(
            &folder.join(MANIFEST),
            &QUICK.replace(DEPENDENCIES, &common),
        )
        .unwrap();

        let plane = files::starter(find("plane").unwrap()).unwrap();
        let code = "let d = ray.direction().dot(self.n);\n        \
                    let t = (self.a - ray.origin()).dot(self.n) / d;\n        \
                    within.contains(t).then(|| Hit::new(t, self.n))";
        let missing = "testing::missing(\"the hit within the interval\", None)";
        assert!(plane.contains(missing));
        let disc = files::read("a07-transforms/exercises/solutions/disc.rs").unwrap();
        let done = BTreeMap::from([("plane", plane.replace(missing, code)), ("disc", disc)]);
        let brought = bring(folder, course, &done).unwrap();
        assert_eq!(brought.yours, ["plane", "disc"]);
        let manifest = fs::read_to_string(folder.join(MANIFEST)).unwrap();
        let (quick, _) = manifest.split_once("\n[profile.dev.package.a02").unwrap();
        write(&folder.join(MANIFEST), quick).unwrap();

        let mut program = BTreeMap::new();
        let mut main = "#![allow(dead_code)]\nmod functions;\n".to_owned();
        let mut calls = String::new();
        for page in PAGES {
            program.append(&mut parts(page));
            if page == "a01-image-display" {
                program.retain(|first, _| !first.starts_with("fn set_pixel"));
                program.remove("mod functions;");
                program.insert(
                    "use functions::*;".to_owned(),
                    "use crate::functions::*;".to_owned(),
                );
            }
            let texts: Vec<_> = program.values().map(String::as_str).collect();
            let text = texts.join("\n\n").replace("fn main()", "pub fn main()");
            let text = text.replace("let index = 0;", "let index = y * width + x;");
            let text = text
                .replace("480, 320", "48, 32")
                .replace("samples: 16", "samples: 1");
            let module = page.replace('-', "_");
            write(&folder.join(format!("src/{module}.rs")), &text).unwrap();
            let call = format!(
                "{module}::main().unwrap();\nstd::fs::rename(\"picture.png\", \"{page}\").unwrap();\n"
            );
            calls += &call;
            main.extend(["mod ", &module, ";\n"]);
        }
        main.extend(["fn main() {\n", &calls, "}\n"]);
        write(&folder.join("src/main.rs"), &main).unwrap();
        let mut cargo = Command::new("cargo");
        cargo.env("CARGO_TARGET_DIR", files::workspace().join("target"));
        cargo.args(["run", "--offline"]).current_dir(folder);
        let output = cargo.output().unwrap();
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{errors}");
        assert!(!errors.contains("warning"), "{errors}");

        let pictures = PAGES.map(|page| picture_file::open(&folder.join(page)).unwrap());
        for two in pictures.windows(2) {
            assert_ne!(two[0], two[1]);
        }
        let [first, cross, ball, ..] = pictures;
        assert_eq!(first.get(100, 100), Some(Color::RED));
        assert_eq!(first.get(101, 100), Some(Color::BLACK));
        assert_eq!(cross.get(139, 100), Some(Color::BLUE));
        // The light comes from there, and arrives with the cosine 1.
        assert_eq!(ball.get(217, 62), Some(Color::WHITE));

        // A function that is edited in the program stays as it is.
        let sphere = folder.join("src/functions/sphere.rs");
        write(&sphere, "pub struct Sphere;\n").unwrap();
        assert_eq!(bring(folder, course, &done).unwrap().edited, ["sphere"]);
        assert_eq!(fs::read_to_string(&sphere).unwrap(), "pub struct Sphere;\n");
    }

    #[test]
    fn examples_are_left_out() {
        let text = "use crate::prelude::*;\n\ntesting::examples! {\n    f();\n}\n\nfn g() {\n}\n";
        assert_eq!(in_program(text), "use super::*;\n\n\nfn g() {\n}\n");
        assert_eq!(in_program("use a;\ntesting::examples! {}"), "use a;\n");
    }
}
