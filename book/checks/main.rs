//! Writes the lists of the files that each stage adds to the stages below; `book/build`
//! runs it.

use std::process::ExitCode;

use book::{Files, changes};

fn main() -> ExitCode {
    let written = Files::read().and_then(|files| changes::write(&files));
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("could not write the lists of the files of the stages: {error}");
            ExitCode::FAILURE
        }
    }
}
