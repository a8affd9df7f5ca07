//! `book`: builds the book with the student's exercises in it.

use std::process::{Command, ExitCode};

use crate::exercise::Exercise;
use crate::{files, progress};

/// Builds the book with the exercises that are done.
pub fn build(course: &[Exercise]) -> Result<ExitCode, String> {
    let yours = yours(course, progress::is_done);
    if yours.is_empty() {
        return Err("no exercise is done".to_owned());
    }
    let mut build = Command::new("bash");
    build.arg("book/build").env("YOURS", yours);
    let status = build.current_dir(files::workspace()).status();
    let status = status.map_err(|error| format!("bash does not start: {error}"))?;
    Ok(ExitCode::from(u8::from(!status.success())))
}

/// The files for `book/build`, each as `STAGE/NAME`.
fn yours(course: &[Exercise], is_done: fn(&Exercise) -> bool) -> String {
    let done = course.iter().filter(|e| is_done(e));
    done.flat_map(|e| [e.stage, "/", e.name, " "]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_book_shows_what_is_done() {
        let is_done = |e: &Exercise| ["length", "ray"].contains(&e.name);
        let files = yours(&crate::exercise::read_all().unwrap(), is_done);
        assert_eq!(files, "a02-math/length a03-rays-cameras/ray ");
    }
}
