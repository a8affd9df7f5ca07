//! Shows the picture of assignment 2.

#![cfg_attr(target_family = "wasm", no_main)]

#[cfg(not(target_family = "wasm"))]
fn main() -> std::process::ExitCode {
    command_line::run(&a02_math::stage(), a01_image_display::viewer())
}
