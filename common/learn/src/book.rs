//! `book`: builds the book with the student's exercises in it.

use std::process::{Command, ExitCode};

use crate::exercise::Exercise;
use crate::{files, progress};

/// Builds the book with the exercises that are done.
pub fn build(course: &[Exercise]) -> Result<ExitCode, String> {
    let done = course.iter().filter(|e| progress::is_done(e));
    let yours: String = done.flat_map(|e| [e.stage, "/", e.name, " "]).collect();
    if yours.is_empty() {
        return Err("no exercise is done".to_owned());
    }
    let mut build = Command::new("bash");
    build.arg("book/build").env("YOURS", yours);
    let status = build.current_dir(files::workspace()).status();
    let status = status.map_err(|error| format!("bash does not start: {error}"))?;
    Ok(ExitCode::from(u8::from(!status.success())))
}
