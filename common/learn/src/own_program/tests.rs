//! The program of the book, page by page.

use std::env;
use std::process::Command;

use common::{Color, Image, picture_file};

use super::*;
use crate::exercise::{find, read_all};
use crate::starter::starter;

/// Libraries from outside are built as for the workbook, and nothing else is optimised: so it is
/// soon built.
const QUICK: &str = "[package]\nname = \"my-tracer\"\nedition = \"2024\"\n\n[dependencies]\n
[profile.dev]
codegen-units = 1
opt-level = 0
debug = false

[profile.dev.package]
\"*\".debug-assertions = false
\"*\".overflow-checks = false
fearless_simd.opt-level = 1
jpeg-decoder.opt-level = 1
libm.opt-level = 3
png.opt-level = 2
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

/// The book's picture of a page, from the first with light of its own on: `INSTA_UPDATE=always` draws it, in a minute.
fn shown(page: &str) -> PathBuf {
    files::workspace().join(format!("book/src/pictures/tonight-{page}.png"))
}

/// The picture of each page, by the program as it is there: modules of one program, which is
/// built once. They are a tenth as wide and high as those of the book.
#[test]
fn the_program_of_the_book_draws_a_picture_on_each_page() {
    if find("disc").is_err() {
        eprintln!("skipped: this workbook lacks the stage of the last page");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write(&folder.join(MANIFEST), QUICK).unwrap();

    let plane = starter(find("plane").unwrap()).unwrap();
    let code = "let d = ray.direction().dot(self.n);\n        \
                let t = (self.a - ray.origin()).dot(self.n) / d;\n        \
                within.contains(t).then(|| Hit::new(t, self.n))";
    let missing = "testing::missing(\"the hit within the interval\", None)";
    assert!(plane.contains(missing));
    let disc = files::read("a07-transforms/exercises/solutions/disc.rs").unwrap();
    let mut done = BTreeMap::from([("plane", plane.replace(missing, code)), ("disc", disc)]);
    for step in sheet::steps().unwrap() {
        let e = find(&step).unwrap();
        let solution = files::read(e.solution).unwrap();
        // In a workbook without solutions it is a starter.
        if !solution.contains("testing::missing(") {
            done.insert(e.name, solution);
        }
    }
    let mut brought = bring(folder, &done).unwrap();
    brought.yours.sort_unstable();
    assert!(brought.yours.iter().eq(done.keys()), "{:?}", brought.yours);
    let manifest = fs::read_to_string(folder.join(MANIFEST)).unwrap();
    let of_stage = "[profile.dev.package.a02";
    let (before, optimised) = manifest.split_once(of_stage).unwrap();
    let (_, after) = optimised.split_once("[profile.release").unwrap();
    let quick = format!("{before}[profile.release{after}");
    write(&folder.join(MANIFEST), &quick).unwrap();

    let updates = env::var_os("INSTA_UPDATE").is_some();
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
        let text = if updates {
            text
        } else {
            text.replace("480, 320", "48, 32")
                .replace("samples: 16", "samples: 1")
        };
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

    for page in &PAGES[2..] {
        let drawn = folder.join(page);
        if updates {
            fs::copy(&drawn, shown(page)).unwrap();
        }
        let [drawn, shown] = [drawn, shown(page)].map(|path| picture_file::open(&path).unwrap());
        let difference = difference(&drawn, &shown);
        assert!(difference < 0.03, "{page}: {difference}");
    }
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
    assert_eq!(bring(folder, &done).unwrap().edited, ["sphere"]);
    assert_eq!(fs::read_to_string(&sphere).unwrap(), "pub struct Sphere;\n");
}

fn bring(folder: &Path, done: &BTreeMap<&str, String>) -> Result<Brought, String> {
    let brought = Brought::new(folder, read_all()?, done)?;
    brought.write()?;
    Ok(brought)
}

/// The mean difference of a picture's channels from the pixel of a larger one at the same place.
fn difference(small: &Image, large: &Image) -> f64 {
    let factor = large.size().width() / small.size().width();
    let mut sum = 0.0;
    for (y, row) in (0..).zip(small.rows()) {
        for (x, color) in (0..).zip(row) {
            let other = large
                .get(x * factor + factor / 2, y * factor + factor / 2)
                .unwrap();
            let channels = color.channels().into_iter().zip(other.channels());
            sum += channels.map(|(a, b)| (a - b).abs()).sum::<f64>();
        }
    }
    sum / (3 * small.size().pixels()) as f64
}

/// The manifest of a program that has this one, with the functions of stage 1, and its lock file.
fn completed(before: &str, lock: Option<&str>) -> (String, String) {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write(&folder.join(MANIFEST), before).unwrap();
    write(&folder.join("src/main.rs"), "fn main() {}").unwrap();
    if let Some(lock) = lock {
        write(&folder.join("Cargo.lock"), lock).unwrap();
    }
    let solution = files::read("a01-image-display/exercises/solutions/diagonal.rs").unwrap();
    let done = BTreeMap::from([("diagonal", solution)]);
    bring(folder, &done).unwrap();
    let read = |name| fs::read_to_string(folder.join(name)).unwrap();
    let (manifest, lock) = (read(MANIFEST), read("Cargo.lock"));
    assert!(!manifest.contains("a02-math"), "{manifest}");
    // A second time, nothing is missing.
    let brought = bring(folder, &done).unwrap();
    assert_eq!(brought.manifest.words(), "");
    assert_eq!(read(MANIFEST), manifest);
    (manifest, lock)
}

const PACKAGE: &str = "[package]\nname = \"my-tracer\"\nedition = \"2024\"\n";

#[test]
fn a_manifest_keeps_its_lines_and_gets_what_it_lacks() {
    let path = files::workspace().join("common");
    let libraries = format!(
        "\n[dependencies.libm]\nversion = \"0.2\"\n\n[dependencies.common]\npath = {path:?}\n"
    );
    let mut lacking = libraries + "\n[profile.dev]\nopt-level = 3\n";
    for (name, level) in [
        ("dev.package.\"*\"", "0"),
        ("dev.package.common", "3"),
        ("dev.package.libm", "3"),
        ("release.package.image", "0"),
        ("release.package.moxcms", "0"),
        ("release.package.pxfm", "0"),
    ] {
        lacking.extend(["\n[profile.", name, "]\nopt-level = ", level, "\n"]);
    }
    for own in [
        "\n[dependencies]\n",
        "\n[dependencies] # mine\n# Numbers.\n",
        "",
    ] {
        let before = format!("{PACKAGE}{own}");
        let (manifest, lock) = completed(&before, None);
        assert_eq!(manifest, format!("{before}{lacking}"));
        assert_eq!(lock, files::read("Cargo.lock").unwrap());
    }
    let before = format!("{PACKAGE}\n[dependencies]");
    assert_eq!(completed(&before, None).0, format!("{before}\n{lacking}"));
    let before = format!("{PACKAGE}\n[dependencies]\n");
    let windows = |text: &str| text.replace('\n', "\r\n");
    assert_eq!(
        completed(&windows(&before), None).0,
        windows(&(before + &lacking))
    );

    // What the student has said of a library or a profile stays; an older program lacks the profile of releases.
    let before = format!(
        "{PACKAGE}\n[dependencies]\nlibm = {{ version = \"0.2.1\" }} # new\ncommon = {{ path = {path:?} }}\n\n\
         [profile.dev]\nopt-level = 1\n\n[profile.release.package]\nimage.opt-level = 2\n"
    );
    let (_, spared) = lacking
        .split_once("[profile.release.package.image]\nopt-level = 0\n")
        .unwrap();
    assert_eq!(completed(&before, None).0, format!("{before}{spared}"));
}

/// Of a library that the program has locked at an older version than that of the workbook, and no other uses.
#[test]
fn the_versions_of_a_program_stay() {
    let lock = files::read("Cargo.lock").unwrap();
    let own = "[[package]]\nname = \"my-tracer\"\nversion = \"0.0.0\"\n";
    let own = format!("version = 4\n\n{own}");
    let (_, kept) = completed(PACKAGE, Some(&own));
    assert_ne!(kept, lock);
    assert!(kept.contains("my-tracer"), "{kept}");
}

#[test]
fn examples_are_left_out() {
    let text = "// testing::examples! {\nconst A: &str = \"testing::examples! {}\";\n\
        mod a { use crate::prelude::Ray; /* crate::prelude */ }\ntesting::examples! { /* } */ \"}\"; '}' }";
    let kept = "// testing::examples! {\nconst A: &str = \"testing::examples! {}\";\n\
        mod a { use super::Ray; /* crate::prelude */ }\n";
    assert_eq!(in_program(text).unwrap(), kept);
}
