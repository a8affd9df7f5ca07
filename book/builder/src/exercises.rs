//! The table of the exercises of each stage, for its page.

use std::path::Path;

use learn::exercise::{self, Exercise};

use crate::file;

const FOLDER: &str = "book/generated/exercises";

const HEAD: &str =
    "| exercise | file | path | minutes | what it teaches |\n|---|---|---|---:|---|\n";

/// Writes the tables, which the pages include.
pub fn write() -> Result<(), String> {
    for of_stage in exercise::read_all()?.chunk_by(|a, b| a.stage == b.stage) {
        let rows: String = of_stage.iter().map(row).collect();
        let path = Path::new(FOLDER).join(format!("{}.md", of_stage[0].stage));
        file::write(&path, &[HEAD, &rows].concat())?;
    }
    Ok(())
}

fn row(e: &Exercise) -> String {
    let path = if e.is_core { "core" } else { "further" };
    let (title, page, name) = (e.title, &e.stage[..3], e.name);
    let heading = heading_id(title);
    format!(
        "| [{title}]({page}-exercises.md#{heading}) | `{name}` | {path} | {} | {} |\n",
        e.minutes, e.teaches
    )
}

/// The id that mdBook gives to a heading.
fn heading_id(title: &str) -> String {
    let mut id = String::new();
    for letter in title.to_lowercase().chars() {
        if letter.is_alphanumeric() || ['-', '_'].contains(&letter) {
            id.push(letter);
        } else if letter == ' ' {
            id.push('-');
        }
    }
    id
}
