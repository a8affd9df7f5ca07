//! Shows the pictures of assignment 4.

fn main() -> std::process::ExitCode {
    program::run(&a04_intersections::stage(), a01_image_display::viewer())
}
