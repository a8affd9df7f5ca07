//! Shows the pictures of assignment 5.

#![cfg_attr(target_family = "wasm", no_main)]

#[cfg(not(target_family = "wasm"))]
fn main() -> std::process::ExitCode {
    command_line::run(&a05_lighting::stage(), a01_image_display::viewer())
}
