//! Shows the pictures of assignment 3.

fn main() -> std::process::ExitCode {
    program::run(&a03_rays_cameras::stage(), a01_image_display::viewer())
}
