//! `book`: builds the book with the student's exercises in it.

use std::process::Command;

use crate::exercise::Exercise;
use crate::files;
use crate::progress::Progress;

/// Builds the book with the exercises that are done.
pub fn build(course: &[Exercise]) -> Result<String, String> {
    let progress = Progress::read();
    let mut yours = Vec::new();
    for e in course.iter().filter(|e| progress.is_done(e)) {
        yours.push(format!("{}/{}", e.stage, e.name));
    }
    if yours.is_empty() {
        return Err("no exercise is done".to_owned());
    }
    let workspace = files::workspace();
    if !workspace.join("book/builder").is_dir() {
        return Err(
            "this workbook lacks the folder book/builder, which builds the book".to_owned(),
        );
    }
    let mut build = Command::new("cargo");
    build.args(["book", "--yours"]).args(&yours);
    match build.current_dir(workspace).status() {
        Ok(status) if status.success() => Ok(format!("with pictures by your {}", yours.join(" "))),
        Ok(_) => Err("the book is not built".to_owned()),
        Err(error) => Err(format!("cargo does not start: {error}")),
    }
}
