//! Shows the pictures of assignment 7.

fn main() -> std::process::ExitCode {
    program::run(&a07_transforms::stage(), a01_image_display::viewer())
}
