//! Shows the pictures of assignment 5.

fn main() -> std::process::ExitCode {
    program::run(&a05_lighting::stage(), a01_image_display::viewer())
}
