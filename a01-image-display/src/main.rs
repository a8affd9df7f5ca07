//! The program of this stage: shows its scenes or writes them as PNG.

fn main() -> std::process::ExitCode {
    program::run(&a01_image_display::stage(), a01_image_display::viewer())
}
