//! Shows the picture of assignment 2.

use std::process::ExitCode;

fn main() -> ExitCode {
    program::run(&a02_math::stage(), a01_image_display::viewer())
}
