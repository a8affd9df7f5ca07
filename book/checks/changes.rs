//! The list of the files that a stage adds to the stages below.
//!
//! A chapter includes it as `{{#include ../changes/STAGE.md}}`.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::{fs, io};

use crate::Files;
use crate::files::top;
use crate::page::complaint;

/// The stages whose list differs from their sources.
#[must_use]
pub fn complaints(files: &Files) -> Vec<String> {
    let lists = files
        .stages()
        .map(|stage| (path(stage), list(files, stage)));
    let stale = lists.filter(|(path, list)| files.text(path) != Some(list));
    stale
        .map(|(path, _)| complaint(&path, 1, "renew this list with `cargo run -p book`"))
        .collect()
}

/// Writes the lists of all stages.
pub fn write(files: &Files) -> io::Result<()> {
    for stage in files.stages() {
        fs::write(top().join(path(stage)), list(files, stage))?;
    }
    Ok(())
}

fn path(stage: &str) -> String {
    format!("book/changes/{stage}.md")
}

/// The stages that this stage uses, and a line for each of its files.
fn list(files: &Files, stage: &str) -> String {
    let mut list = String::new();
    let below = files.stages().take_while(|below| *below != stage);
    let used: Vec<_> = below
        .filter_map(|below| {
            let names = names_used(files, stage, below);
            let names: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
            (!names.is_empty()).then(|| format!("- `{below}`: {}\n", names.join(", ")))
        })
        .collect();
    if !used.is_empty() {
        let _ = writeln!(list, "From the stages below it takes\n\n{}", used.concat());
    }
    list.push_str("| file | lines, about | what it is |\n|---|---:|---|\n");
    let folder = format!("{stage}/src/");
    for (path, text) in files.below(&folder) {
        let name = &path[folder.len()..];
        let Some(room) = name.strip_suffix(".rs").filter(|room| is_listed(room)) else {
            continue;
        };
        let inner = files.below(&folder).filter(|(path, _)| {
            let below = path[folder.len()..].strip_prefix(room);
            below.is_some_and(|below| below.starts_with('/'))
        });
        let lines =
            text.lines().count() + inner.map(|(_, text)| text.lines().count()).sum::<usize>();
        // Round numbers say as much, and stay true longer.
        let about = lines.div_ceil(10) * 10;
        let _ = writeln!(list, "| `{name}` | {about} | {} |", first_sentence(text));
    }
    list
}

/// Whether a file of this name, without its ending, has a line: all but the files
/// that only gather others, and the files in folders, which are counted there.
fn is_listed(room: &str) -> bool {
    !matches!(room, "lib" | "main") && !room.contains('/')
}

/// Whether a file of this name, without its ending, belongs to the lesson.
fn is_lesson(room: &str) -> bool {
    is_listed(room) && !matches!(room, "stage" | "fast" | "lab")
}

/// The types, traits and constants that the lesson of a stage imports from one below.
fn names_used<'a>(files: &'a Files, stage: &str, below: &str) -> BTreeSet<&'a str> {
    let import = format!("use {}::", below.replace('-', "_"));
    let mut names = BTreeSet::new();
    let folder = format!("{stage}/src/");
    for (path, text) in files.below(&folder) {
        if !path[folder.len()..]
            .strip_suffix(".rs")
            .is_some_and(is_lesson)
        {
            continue;
        }
        for rest in text.split(&import).skip(1) {
            let imported = rest.split(';').next().unwrap_or_default();
            let words = imported.split(|c: char| !c.is_alphanumeric() && c != '_');
            names.extend(words.filter(|word| !word.is_empty() && *word != "self"));
        }
    }
    names
}

/// The first sentence of a file's documentation, on one line.
fn first_sentence(text: &str) -> String {
    let lines = text.lines().map_while(|line| line.strip_prefix("//!"));
    let paragraph = lines.map(str::trim).take_while(|line| !line.is_empty());
    let paragraph = paragraph.collect::<Vec<_>>().join(" ");
    let sentence = match paragraph.split_once(". ") {
        Some((first, _)) => format!("{first}."),
        None => paragraph,
    };
    sentence
        .replace("[`", "`")
        .replace("`]", "`")
        .replace('|', "\\|")
}

#[cfg(test)]
mod tests {
    use super::*;

    const BELOW: (&str, &str) = ("a01-low/Cargo.toml", "");
    const STAGE: (&str, &str) = ("a02-high/Cargo.toml", "");
    const SOURCE: (&str, &str) = (
        "a02-high/src/ray.rs",
        "//! `Ray`: a [`Line`] with\n//! a start. It has an end, too.\n//!\n//! More.\n\n\
         use a01_low::{\n    Line,\n    Point,\n};\nuse a01_low::zero;\n",
    );
    const LIST: &str = "From the stages below it takes\n\n- `a01-low`: `Line`, `Point`, `zero`\n\n\
        | file | lines, about | what it is |\n|---|---:|---|\n\
        | `lab.rs` | 10 | The lab. |\n| `ray.rs` | 20 | `Ray`: a `Line` with a start. |\n";

    #[test]
    fn the_list_is_that_of_the_sources() {
        let files = Files::of([
            BELOW,
            STAGE,
            SOURCE,
            ("a02-high/src/ray/end.rs", "//! The end.\n"),
            (
                "a02-high/src/lab.rs",
                "//! The lab.\n\nuse a01_low::fast;\n",
            ),
            ("a02-high/src/lib.rs", "//! All.\n"),
        ]);
        assert_eq!(list(&files, "a02-high"), LIST);
    }

    #[test]
    fn a_stale_list_is_found() {
        let stale = LIST.replace("20", "30");
        let low = "| file | lines, about | what it is |\n|---|---:|---|\n";
        let files = Files::of([
            BELOW,
            STAGE,
            SOURCE,
            ("book/changes/a01-low.md", low),
            ("book/changes/a02-high.md", &stale),
        ]);
        assert_eq!(
            complaints(&files),
            ["book/changes/a02-high.md:1: renew this list with `cargo run -p book`"]
        );
    }
}
