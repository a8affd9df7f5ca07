//! Shows the pictures of assignment 6.

fn main() -> std::process::ExitCode {
    program::run(
        &a06_shadows_reflection::stage(),
        a01_image_display::viewer(),
    )
}
