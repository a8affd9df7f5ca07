//! A program's manifest in the grading folder: the student's, but for the places of the workbook's crates.

use std::cmp::Reverse;
use std::ops::Range;
use std::path::{Component, Path};

use common::text;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

/// The workbook's crates that a program may use.
pub const CRATES: [&str; 8] = [
    "common",
    "a01-image-display",
    "a02-math",
    "a03-rays-cameras",
    "a04-intersections",
    "a05-lighting",
    "a06-shadows-reflection",
    "a07-transforms",
];

/// The tables of libraries, also of one system.
const LIBRARIES: [&str; 3] = ["dependencies", "dev-dependencies", "build-dependencies"];

/// The manifest of a package that lies so many folders below that of the program. An error says what is in the way.
pub fn in_grading_folder(students: &str, depth: usize) -> Result<String, String> {
    let manifest = DeTable::parse(students).map_err(|error| error.to_string())?;
    let manifest = manifest.get_ref();
    if !manifest.contains_key("package") {
        return Err("it is a workspace; hand in the folder of the program".to_owned());
    }
    let mut owners = vec![manifest];
    for (_, system) in manifest.get("target").into_iter().flat_map(entries) {
        owners.extend(system.get_ref().as_table());
    }
    let mut paths = Vec::new();
    for owner in owners {
        for table in LIBRARIES {
            for (name, library) in owner.get(table).into_iter().flat_map(entries) {
                paths.extend(place(name.get_ref(), library.get_ref(), depth)?);
            }
        }
    }
    let mut placed = students.to_owned();
    // The last one first, so that the others do not move.
    paths.sort_by_key(|(range, _)| Reverse(range.start));
    for (range, path) in paths {
        placed.replace_range(range, &path);
    }
    // So Cargo looks for no workspace in the folders around the program.
    if depth == 0 && !manifest.contains_key("workspace") {
        placed += "\n[workspace]\n";
    }
    Ok(placed)
}

/// The entries of a table.
fn entries<'a>(
    table: &'a Spanned<DeValue<'a>>,
) -> impl Iterator<Item = (&'a Spanned<DeString<'a>>, &'a Spanned<DeValue<'a>>)> {
    table.get_ref().as_table().into_iter().flatten()
}

/// Where the path of one of the workbook's crates stands in the manifest, and its path in the grading folder.
fn place(
    name: &str,
    library: &DeValue,
    depth: usize,
) -> Result<Option<(Range<usize>, String)>, String> {
    let Some(library) = library.as_table() else {
        return Ok(None);
    };
    let Some(path) = library.get("path") else {
        return Ok(None);
    };
    let package = library
        .get("package")
        .and_then(|name| name.get_ref().as_str());
    let package = package.unwrap_or(name);
    if CRATES.contains(&package) {
        let up = "../".repeat(depth + 1);
        return Ok(Some((path.span(), format!("\"{up}workbook/{package}\""))));
    }
    let is_within = path
        .get_ref()
        .as_str()
        .is_some_and(|path| is_within(path, depth));
    if is_within {
        return Ok(None);
    }
    let name = text::name(name);
    Err(format!(
        "the library {name} lies outside of the folder that is handed in"
    ))
}

/// Whether a path leads no further up than to the program's folder, so many folders above.
fn is_within(path: &str, depth: usize) -> bool {
    let mut depth = depth;
    for part in Path::new(path).components() {
        match part {
            Component::Normal(_) => depth += 1,
            Component::CurDir => {}
            Component::ParentDir if depth > 0 => depth -= 1,
            _ => return false,
        }
    }
    true
}
