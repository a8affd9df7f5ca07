//! mdBook, installed below `target/`.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::command::{output, run};
use crate::file;

const VERSION: &str = "0.5.3";

/// The folder in which it is installed.
const FOLDER: &str = "target/book-tools";

/// The program.
pub fn command() -> Command {
    Command::new(Path::new(FOLDER).join("bin/mdbook"))
}

/// Installs the program, unless this version is there already.
pub fn install() -> Result<(), String> {
    let printed = output(command().arg("--version")).unwrap_or_default();
    if printed.trim() == format!("mdbook v{VERSION}") {
        return Ok(());
    }
    println!("installing mdbook {VERSION}, which takes a minute, once");
    let folder = file::absolute(Path::new(FOLDER))?;
    let build = folder.join("build");
    let mut cargo = Command::new("cargo");
    // A program that runs for a second need not be optimised, and then builds sooner.
    cargo.env("CARGO_PROFILE_DEV_DEBUG", "false");
    cargo.env("CARGO_TARGET_DIR", &build);
    cargo.args(["install", "--quiet", "--locked", "--debug", "--root"]);
    cargo.arg(folder).arg(format!("mdbook@{VERSION}"));
    run(cargo.args(["--no-default-features", "--features", "search"]))?;
    fs::remove_dir_all(&build).map_err(file::with_path(&build))
}
