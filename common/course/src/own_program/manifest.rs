//! The manifest with which the grader builds a program.

use std::collections::BTreeMap;
use std::fmt::Write;

use common::text;
use toml::de::{DeTable, DeValue};

pub const MANIFEST: &str = "Cargo.toml";

/// The workbook's crates that a program may use. All programs are built with all of them, which are built once.
const CRATES: [&str; 8] = [
    "common",
    "a01-image-display",
    "a02-math",
    "a03-rays-cameras",
    "a04-intersections",
    "a05-lighting",
    "a06-shadows-reflection",
    "a07-transforms",
];

/// The manifest with which the grader builds a program: its own paths to the workbook's crates, and the student's
/// other libraries. Build scripts and profiles stay behind.
pub fn manifest(students: &str) -> Result<String, String> {
    let table = DeTable::parse(students).map_err(|error| format!("{MANIFEST}: {error}"))?;
    let section = |name: &str| {
        table
            .get_ref()
            .get(name)
            .and_then(|table| table.get_ref().as_table())
    };
    let package =
        |key: &str| section("package").and_then(|table| table.get(key)?.get_ref().as_str());
    let name = package("name").unwrap_or("program");
    let edition = package("edition").unwrap_or("2024");
    let mut manifest = format!("[package]\nname = {name:?}\nedition = {edition:?}\n");
    if let Some(name) = package("default-run") {
        let _ = writeln!(manifest, "default-run = {name:?}");
    }
    manifest += "\n[workspace]\n\n[dependencies]\n";
    for name in CRATES {
        let features = if name == "common" {
            ""
        } else {
            ", default-features = false"
        };
        let _ = writeln!(
            manifest,
            "{name} = {{ path = \"../workbook/{name}\"{features} }}"
        );
    }
    let mut libraries = BTreeMap::from([("libm", "\"0.2\"".to_owned())]);
    for (name, value) in section("dependencies").into_iter().flatten() {
        let name = &**name.get_ref();
        if !CRATES.contains(&name) {
            libraries.insert(name, library(name, value.get_ref())?);
        }
    }
    for (name, value) in libraries {
        let _ = writeln!(manifest, "{name:?} = {value}");
    }
    Ok(manifest)
}

/// A library from outside, with its version and features.
fn library(name: &str, value: &DeValue) -> Result<String, String> {
    let table = value.as_table();
    let of_table = |key: &str| table.and_then(|table| Some(table.get(key)?.get_ref()));
    let version = value.as_str().or_else(|| of_table("version")?.as_str());
    let Some(version) = version else {
        let problem = "is handed in by its version only, and no path";
        return Err(format!(
            "{MANIFEST}: the library {} {problem}",
            text::name(name)
        ));
    };
    let mut features = Vec::new();
    for feature in of_table("features")
        .and_then(DeValue::as_array)
        .into_iter()
        .flatten()
    {
        features.extend(feature.get_ref().as_str());
    }
    let default = of_table("default-features").and_then(DeValue::as_bool) != Some(false);
    Ok(format!(
        "{{ version = {version:?}, features = {features:?}, default-features = {default} }}"
    ))
}
