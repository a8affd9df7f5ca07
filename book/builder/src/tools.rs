//! The programs that build the book, installed below `target/`.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::command::{output, run};
use crate::file;

/// A program from crates.io.
struct Tool {
    name: &'static str,
    version: &'static str,
    /// Further arguments of `cargo install`.
    arguments: &'static [&'static str],
}

const TOOLS: [Tool; 2] = [
    // Of the version for which mdbook-katex is built: it warns of another one.
    Tool {
        name: "mdbook",
        version: "0.5.3",
        arguments: &["--no-default-features", "--features", "search"],
    },
    Tool {
        name: "mdbook-katex",
        version: "0.10.0",
        arguments: &[],
    },
];

/// A command for one of the programs. It finds the others: mdBook starts mdbook-katex.
pub fn command(name: &str) -> Result<Command, String> {
    let mut command = Command::new(name);
    command.env("PATH", search_path()?);
    Ok(command)
}

/// Installs each program whose version is not there yet, one after the other: they are built in one
/// folder, in which the second one finds libraries of the first one.
pub fn install() -> Result<(), String> {
    TOOLS.iter().try_for_each(Tool::install)?;
    let folder = build_folder()?;
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(file::with_path(&folder))?;
    }
    Ok(())
}

impl Tool {
    fn install(&self) -> Result<(), String> {
        let Self {
            name,
            version,
            arguments,
        } = self;
        if self.is_there()? {
            return Ok(());
        }
        println!("installing {name} {version}, which takes a minute, once");
        let mut cargo = Command::new("cargo");
        // A program that runs for a second need not be optimised, and then builds sooner.
        cargo.env("CARGO_PROFILE_DEV_DEBUG", "false");
        cargo.env("CARGO_TARGET_DIR", build_folder()?);
        cargo.args(["install", "--quiet", "--locked", "--debug", "--root"]);
        cargo.arg(folder()?).arg(format!("{name}@{version}"));
        run(cargo.args(*arguments))
    }

    /// Whether the program of this version is there already.
    fn is_there(&self) -> Result<bool, String> {
        let Ok(printed) = output(command(self.name)?.arg("--version")) else {
            return Ok(false);
        };
        let version = printed.split_whitespace().last().unwrap_or_default();
        Ok(version.trim_start_matches('v') == self.version)
    }
}

/// The folder in which the programs are installed.
fn folder() -> Result<PathBuf, String> {
    file::absolute(Path::new("target/book-tools"))
}

/// The folder in which they are built, which is removed afterwards.
fn build_folder() -> Result<PathBuf, String> {
    Ok(folder()?.join("build"))
}

/// The folders in which programs are looked for, our own first.
fn search_path() -> Result<OsString, String> {
    let ours = folder()?.join("bin");
    let theirs = env::var_os("PATH").unwrap_or_default();
    let all = std::iter::once(ours).chain(env::split_paths(&theirs));
    env::join_paths(all).map_err(|error| error.to_string())
}
