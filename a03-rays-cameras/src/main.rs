//! Shows the pictures of assignment 3.

use std::process::ExitCode;

fn main() -> ExitCode {
    program::run(&a03_rays_cameras::stage(), a01_image_display::viewer())
}
