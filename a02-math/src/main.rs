//! Shows the picture of assignment 2.

fn main() -> std::process::ExitCode {
    program::run(&a02_math::stage(), a01_image_display::viewer())
}
