//! What a stage adds, for its chapter: the names that its lesson takes from the stages below, and
//! a table of its files.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::file;

/// Writes a list for each stage, which its chapter includes.
pub fn write() -> Result<(), String> {
    let stages = file::stages()?;
    for (number, stage) in stages.iter().enumerate() {
        let text = names_from_below(stage, &stages[..number])? + &table_of_files(stage)?;
        let path = Path::new("book/generated/changes").join(format!("{stage}.md"));
        file::write(&path, &text)?;
    }
    Ok(())
}

/// A line for each stage below from which the lesson takes names; empty if there is none.
fn names_from_below(stage: &str, below: &[String]) -> Result<String, String> {
    let mut lesson = String::new();
    for path in sources(stage)? {
        lesson += &file::read(&path)?;
    }
    let mut lines = Vec::new();
    for stage in below {
        let names = imported_names(&lesson, &stage.replace('-', "_"));
        if !names.is_empty() {
            let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
            lines.push(format!("- `{stage}`: {}\n", names.join(", ")));
        }
    }
    if lines.is_empty() {
        return Ok(String::new());
    }
    let lines = lines.concat();
    Ok(format!("From the stages below it takes\n\n{lines}\n"))
}

/// The names in the `use` declarations of a crate, in alphabetical order.
fn imported_names(source: &str, crate_name: &str) -> BTreeSet<String> {
    let without_spaces: String = source.split_whitespace().collect();
    let declaration = format!("use{crate_name}::");
    let mut names = BTreeSet::new();
    for after in without_spaces.split(&declaration).skip(1) {
        let imported = after.split(';').next().unwrap_or_default();
        for name in imported.split(|letter: char| !letter.is_alphanumeric() && letter != '_') {
            if !name.is_empty() && name != "self" {
                names.insert(name.to_owned());
            }
        }
    }
    names
}

/// The files and folders of a stage, with their lengths and the first sentences of their documentation.
fn table_of_files(stage: &str) -> Result<String, String> {
    let mut rows = vec!["| file | lines, about | what it is |\n|---|---:|---|\n".to_owned()];
    for path in file::entries(&Path::new(stage).join("src"))? {
        let stem = file::stem(&path);
        let (name, first, files) = if path.is_dir() {
            let files = file::files_below(&path)?;
            (format!("{stem}/"), path.join("mod.rs"), files)
        } else if stem == "lib" || stem == "main" {
            continue;
        } else {
            (format!("{stem}.rs"), path.clone(), vec![path])
        };
        let lines = count_lines(&files)?;
        let sentence = first_sentence(&file::read(&first)?);
        rows.push(format!("| `{name}` | {lines} | {sentence} |\n"));
    }
    let lines = count_lines(&file::files_below(&Path::new(stage).join("lab/src"))?)?;
    let sentence = "The laboratory, a crate of its own: it measures the lesson.";
    rows.push(format!("| `lab/` | {lines} | {sentence} |\n"));
    Ok(rows.concat())
}

/// The Rust files in the first level of a stage's sources.
fn sources(stage: &str) -> Result<Vec<PathBuf>, String> {
    let mut paths = file::entries(&Path::new(stage).join("src"))?;
    paths.retain(|path| file::has_extension(path, "rs"));
    Ok(paths)
}

/// The number of lines of the Rust files among these, rounded up to tens.
fn count_lines(files: &[PathBuf]) -> Result<usize, String> {
    let mut lines = 0;
    for path in files {
        if file::has_extension(path, "rs") {
            lines += file::read(path)?.lines().count();
        }
    }
    Ok(lines.next_multiple_of(10))
}

/// The first sentence of the documentation of a file, without links.
fn first_sentence(source: &str) -> String {
    let mut documentation = Vec::new();
    for line in source.lines() {
        match line.strip_prefix("//! ") {
            Some(words) => documentation.push(words),
            None => break,
        }
    }
    let documentation = documentation.join(" ");
    let sentence = match documentation.split_once(". ") {
        Some((sentence, _)) => format!("{sentence}."),
        None => documentation,
    };
    sentence.replace("[`", "`").replace("`]", "`")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_all_declarations_of_the_crate() {
        let source = "use a02_math::{\n    Direction,\n    arrays::{self, array},\n};\nuse a02_math::Point3;\nuse glam::DVec3;";
        let names = imported_names(source, "a02_math");
        let expected = ["Direction", "Point3", "array", "arrays"];
        assert_eq!(names.into_iter().collect::<Vec<_>>(), expected);
    }

    #[test]
    fn the_first_sentence_ends_at_a_full_stop_and_a_space() {
        let source = "//! [`Hit`]: where t is 0.5\n//! or more. And more.\n\nuse glam;";
        assert_eq!(first_sentence(source), "`Hit`: where t is 0.5 or more.");
    }
}
