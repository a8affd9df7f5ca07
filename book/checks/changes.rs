//! The list of the files that a stage adds to the stages below, which the chapter of
//! the stage includes.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::{fs, io};

use crate::Files;
use crate::files::top;

/// Writes the lists of all stages into `book/generated/changes`.
pub fn write(files: &Files) -> io::Result<()> {
    let folder = top().join("book/generated/changes");
    fs::create_dir_all(&folder)?;
    for stage in files.stages() {
        fs::write(folder.join(format!("{stage}.md")), list(files, stage))?;
    }
    Ok(())
}

/// The stages that this stage uses, and a line for each of its files.
fn list(files: &Files, stage: &str) -> String {
    let mut list = String::new();
    for below in files.stages().take_while(|below| *below != stage) {
        let names = names_used(files, stage, below);
        if !names.is_empty() {
            let names: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
            let _ = writeln!(list, "- `{below}`: {}", names.join(", "));
        }
    }
    if !list.is_empty() {
        list = format!("From the stages below it takes\n\n{list}\n");
    }
    list.push_str("| file | lines, about | what it is |\n|---|---:|---|\n");
    for (room, text) in rooms(files, stage) {
        let inner = files.below(format!("{stage}/src/{room}/"));
        let inner: usize = inner.map(|(_, text)| text.lines().count()).sum();
        let about = (text.lines().count() + inner).div_ceil(10) * 10;
        let sentence = first_sentence(text);
        let _ = writeln!(list, "| `{room}.rs` | {about} | {sentence} |");
    }
    list
}

/// The names, without the ending, and the texts of the files of a stage, except those
/// that only name others. The files in a folder belong to the file of its name.
fn rooms<'a>(files: &'a Files, stage: &str) -> impl Iterator<Item = (&'a str, &'a str)> {
    let folder = format!("{stage}/src/");
    let start = folder.len();
    files.below(folder).filter_map(move |(path, text)| {
        let room = path[start..].strip_suffix(".rs")?;
        let is_listed = !matches!(room, "lib" | "main") && !room.contains('/');
        is_listed.then_some((room, text))
    })
}

/// The types, traits and constants that the lesson of a stage imports from one below.
fn names_used<'a>(files: &'a Files, stage: &str, below: &str) -> BTreeSet<&'a str> {
    let import = format!("use {}::", below.replace('-', "_"));
    let mut names = BTreeSet::new();
    let is_lesson = |room: &str| !matches!(room, "stage" | "fast" | "lab");
    for (_, text) in rooms(files, stage).filter(|(room, _)| is_lesson(room)) {
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
    let (first, _) = paragraph.split_once(". ").unwrap_or((&paragraph, ""));
    let sentence = format!("{}.", first.trim_end_matches('.'));
    sentence
        .replace("[`", "`")
        .replace("`]", "`")
        .replace('|', "\\|")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_has_the_imports_and_files_of_a_stage() {
        let ray = "//! `Ray`: a [`Line`] with\n//! a start. It has an end, too.\n//!\n//! More.\n\n\
             use a01_low::{\n    Line,\n    Point,\n};\nuse a01_low::zero;\n";
        let files = Files::of([
            ("a01-low/src/lib.rs", ""),
            ("a02-high/src/lib.rs", "//! All.\n"),
            ("a02-high/src/ray.rs", ray),
            ("a02-high/src/ray/end.rs", "//! The end.\n"),
            (
                "a02-high/src/lab.rs",
                "//! The lab.\n\nuse a01_low::fast;\n",
            ),
        ]);
        let expected = "From the stages below it takes\n\n\
            - `a01-low`: `Line`, `Point`, `zero`\n\n\
            | file | lines, about | what it is |\n|---|---:|---|\n\
            | `lab.rs` | 10 | The lab. |\n| `ray.rs` | 20 | `Ray`: a `Line` with a start. |\n";
        assert_eq!(list(&files, "a02-high"), expected);
    }
}
