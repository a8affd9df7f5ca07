//! Shows the pictures of assignment 7.

use std::process::ExitCode;

fn main() -> ExitCode {
    program::run(&a07_transforms::stage(), a01_image_display::viewer())
}
