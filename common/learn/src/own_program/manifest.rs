//! The manifest of the student's program: the workbook's crates, and profiles with which pictures take seconds, and the
//! first build no minutes. What it lacks is added at its end, so that the student's lines stay as they are.

use std::path::{Path, PathBuf};
use std::process::Command;

use common::text;
use toml::de::{DeTable, DeValue};

use crate::files::{self, MANIFEST, existing, with_path, write};

const LOCK: &str = "Cargo.lock";

/// In a manifest without a profile for `cargo run`, what draws is optimised, and other libraries stay as they are built.
const DEV: [(&str, u8); 3] = [("*", 0), ("common", 3), ("libm", 3)];

/// Libraries that only read files of pictures, and would take most of a release build if they were optimised.
const SPARED: [&str; 3] = ["image", "moxcms", "pxfm"];

/// A manifest that lacks nothing.
pub struct Manifest {
    path: PathBuf,
    text: String,
    /// The names of the libraries and profiles that have been added.
    added: Vec<String>,
}

impl Manifest {
    /// The manifest of the program in a folder, with `common`, `libm`, these stages, and the profiles.
    pub fn new(folder: &Path, stages: &[&str]) -> Result<Self, String> {
        let path = folder.join(MANIFEST);
        let completed = complete(files::text_of(&path)?, stages);
        let (text, added) = completed.map_err(|error| format!("{}: {error}", text::path(&path)))?;
        Ok(Self { path, text, added })
    }

    /// What is added, and what follows; nothing if nothing is.
    pub fn words(&self) -> String {
        if self.added.is_empty() {
            return String::new();
        }
        let (path, added) = (text::path(&self.path), self.added.join(", "));
        format!("{path} gets {added}; the next build takes up to a minute")
    }

    /// Writes it, if something is added.
    pub fn write(&self) -> Result<(), String> {
        if self.added.is_empty() {
            return Ok(());
        }
        write(&self.path, &self.text)?;
        let lock = self.path.with_file_name(LOCK);
        if existing(&lock)?.is_none() {
            // The versions of libraries that the workbook is tested with, and has fetched.
            return write(&lock, &files::read(LOCK)?);
        }
        // The student's versions stay, and Cargo adds those of new libraries that the workbook has fetched. Without them
        // it fails here, and fetches them for the next build.
        let mut cargo = Command::new("cargo");
        cargo.args(["update", "--workspace", "--offline", "--quiet"]);
        cargo.current_dir(self.path.parent().unwrap_or(Path::new("")));
        cargo.output().map_err(with_path("cargo".as_ref()))?;
        Ok(())
    }
}

/// The text of a manifest with `common`, `libm`, these stages and the profiles, and the names of what has
/// been added.
///
/// # Errors
///
/// Fails if it is no TOML, or the place of the workbook cannot be written into it.
pub fn complete(mut text: String, stages: &[&str]) -> Result<(String, Vec<String>), String> {
    let wanted = wanted(stages)?;
    let mut lacking = String::new();
    let mut added = Vec::new();
    {
        let table = DeTable::parse(&text).map_err(|error| error.to_string())?;
        let has_dev = has(table.get_ref(), &["profile", "dev"]);
        for (keys, lines) in &wanted {
            let is_of_dev = keys.starts_with(&["profile", "dev"]);
            let is_kept =
                is_of_dev && has_dev && !keys.last().is_some_and(|name| stages.contains(name));
            if !is_kept && !has(table.get_ref(), keys) {
                let name = keys.join(".").replace('*', "\"*\"");
                lacking.extend(["\n[", &name, "]\n", lines]);
                added.push(match keys[..] {
                    ["dependencies", library] => library.to_owned(),
                    _ => format!("[profile.{}]", keys[1]),
                });
            }
        }
    }
    added.dedup();
    let is_windows = text.contains("\r\n");
    if !text.is_empty() && !text.ends_with('\n') {
        lacking.insert(0, '\n');
    }
    text += &if is_windows {
        lacking.replace('\n', "\r\n")
    } else {
        lacking
    };
    DeTable::parse(&text).map_err(|error| error.to_string())?;
    Ok((text, added))
}

/// The tables of a complete manifest by their keys, and the lines of each.
fn wanted<'a>(stages: &[&'a str]) -> Result<Vec<(Vec<&'a str>, String)>, String> {
    let workspace = files::workspace();
    let Some(workbook) = workspace.to_str().filter(|path| !path.contains('"')) else {
        let workbook = text::path(&workspace);
        return Err(format!("{workbook} cannot be written into a manifest"));
    };
    // Windows takes this, too.
    let workbook = workbook.replace('\\', "/");
    let mut wanted = Vec::new();
    let of_workbook = files::read(MANIFEST)?;
    let of_workbook =
        DeTable::parse(&of_workbook).map_err(|error| format!("{MANIFEST}: {error}"))?;
    let libm = find(
        of_workbook.get_ref(),
        &["workspace", "dependencies", "libm"],
    );
    if let Some(version) = libm.and_then(DeValue::as_str) {
        wanted.push((
            vec!["dependencies", "libm"],
            format!("version = \"{version}\"\n"),
        ));
    }
    wanted.push((
        vec!["dependencies", "common"],
        format!("path = \"{workbook}/common\"\n"),
    ));
    for stage in stages {
        let lines = format!("path = \"{workbook}/{stage}\"\ndefault-features = false\n");
        wanted.push((vec!["dependencies", stage], lines));
    }
    wanted.push((vec!["profile", "dev"], "opt-level = 3\n".to_owned()));
    let of_stages = stages.iter().map(|stage| (*stage, 3));
    for (name, level) in DEV.into_iter().chain(of_stages) {
        let keys = vec!["profile", "dev", "package", name];
        wanted.push((keys, format!("opt-level = {level}\n")));
    }
    for name in SPARED {
        let keys = vec!["profile", "release", "package", name];
        wanted.push((keys, "opt-level = 0\n".to_owned()));
    }
    Ok(wanted)
}

/// The value of a key in tables in tables.
fn find<'a>(table: &'a DeTable<'a>, keys: &[&str]) -> Option<&'a DeValue<'a>> {
    let (first, rest) = keys.split_first()?;
    let value = table.get(*first)?.get_ref();
    if rest.is_empty() {
        Some(value)
    } else {
        find(value.as_table()?, rest)
    }
}

fn has(table: &DeTable, keys: &[&str]) -> bool {
    find(table, keys).is_some()
}
