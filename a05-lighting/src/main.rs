//! Shows the pictures of assignment 5.

use std::process::ExitCode;

fn main() -> ExitCode {
    program::run(&a05_lighting::stage(), a01_image_display::viewer())
}
