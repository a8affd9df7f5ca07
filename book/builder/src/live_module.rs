//! The stages as a WebAssembly module, and the script of the pages, which asks it.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;

use crate::command::{output, run};
use crate::{file, locks, recorded, yours};

/// The target of a browser.
pub const TARGET: &str = "wasm32-unknown-unknown";

/// Flags for a module, instead of those of the user, which may be for another processor. A browser
/// has no random numbers of the system, for which a crate of the exercises asks. It has lanes of 128
/// bits, with which the engine takes a third of the time for the same bytes.
pub const FLAGS: &str = r#"--cfg getrandom_backend="unsupported" -C target-feature=+simd128"#;

/// Scripts of the pages, in the order in which they depend on each other. The hashes of the
/// locked pictures, recorded curves and the reader's exercises stand between them, and the figures behind them.
const BASE: [&str; 3] = ["binding", "worker", "live"];
const PARTS: [&str; 18] = [
    "picture",
    "trace",
    "marks",
    "scene-numbers",
    "dependents",
    "influences",
    "editor",
    "yours",
    "pair",
    "drawing",
    "run",
    "figure",
    "follow",
    "work-precision",
    "measure",
    "extremes",
    "left-out",
    "words",
];

/// The files of a live book that mdBook does not know: a page loads them when the reader first
/// needs them.
pub struct LiveModule {
    /// The modules as scripts.
    pub scripts: Vec<PathBuf>,
}

impl LiveModule {
    /// Builds the module and the script of the pages. None if the target of a browser is missing and
    /// cannot be installed.
    pub fn build(exercises: &[yours::Exercise]) -> Result<Option<Self>, String> {
        if let Err(problem) = install_target() {
            println!(
                "pictures and figures will not be live: {problem}\n\
                 They need the target {TARGET} of Rust, which rustup adds. Where Rust is not \
                 installed by rustup, the system's packages may have it."
            );
            return Ok(None);
        }
        let mut cargo = Command::new("cargo");
        cargo.env("RUSTFLAGS", FLAGS);
        cargo.args(["build", "--quiet", "--locked", "--package", "live"]);
        run(cargo.args(["--profile", "live", "--target", TARGET]))?;

        let yours = yours::build(exercises)?;
        file::write(
            Path::new("book/generated/live.js"),
            &script_of_the_pages(&yours.script)?,
        )?;
        let module = PathBuf::from(format!("target/{TARGET}/live/live.wasm"));
        let script = PathBuf::from("target/live-module.js");
        write_as_script(&module, &script)?;

        let mut scripts = yours.modules;
        scripts.push(script);
        Ok(Some(Self { scripts }))
    }
}

/// Installs the target of a browser, if it is missing.
fn install_target() -> Result<(), String> {
    let mut rustc = Command::new("rustc");
    let folder = output(rustc.args(["--print", "target-libdir", "--target", TARGET]))?;
    if Path::new(folder.trim()).is_dir() {
        return Ok(());
    }
    run(Command::new("rustup").args(["target", "add", TARGET]))
}

/// One script for all pages.
fn script_of_the_pages(yours: &str) -> Result<String, String> {
    let folder = Path::new("book/live/page");
    let part = |name: &str| file::read(&folder.join(format!("{name}.js")));
    let mut script = String::new();
    for name in BASE {
        script += &part(name)?;
    }
    script += &locks::script()?;
    script += &recorded::script()?;
    script += yours;
    for name in PARTS {
        script += &part(name)?;
    }
    for figure in file::entries(&folder.join("figures"))? {
        script += &file::read(&figure)?;
    }
    Ok(script)
}

/// Writes a module as text within a script, which a page that is opened as a file can load.
pub fn write_as_script(module: &Path, script: &Path) -> Result<(), String> {
    let failed = |error| format!("cannot read {}: {error}", module.display());
    let bytes = fs::read(module).map_err(failed)?;
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&bytes).map_err(failed)?;
    let compressed = encoder.finish().map_err(failed)?;
    println!(
        "{}: {} bytes, {} compressed",
        module.display(),
        bytes.len(),
        compressed.len()
    );
    let text = BASE64_STANDARD.encode(compressed);
    file::write(script, &format!("live.receive('{text}');\n"))
}
