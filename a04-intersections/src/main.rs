//! Shows the pictures of assignment 4.

use std::process::ExitCode;

fn main() -> ExitCode {
    program::run(&a04_intersections::stage(), a01_image_display::viewer())
}
