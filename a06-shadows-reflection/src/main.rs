//! Shows the pictures of assignment 6.

use std::process::ExitCode;

fn main() -> ExitCode {
    program::run(
        &a06_shadows_reflection::stage(),
        a01_image_display::viewer(),
    )
}
