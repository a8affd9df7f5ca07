//! Writes the list of the files that each stage adds to the stages below:
//! `cargo run -p book`.

use std::process::ExitCode;

use book::{Files, changes};

fn main() -> ExitCode {
    let written = Files::read().and_then(|files| changes::write(&files));
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("could not write what the stages add: {error}");
            ExitCode::FAILURE
        }
    }
}
