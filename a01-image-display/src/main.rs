//! The program of this stage: shows its scenes or writes them as PNG.

#![cfg_attr(target_family = "wasm", no_main)]

#[cfg(not(target_family = "wasm"))]
fn main() -> std::process::ExitCode {
    command_line::run(&a01_image_display::stage(), a01_image_display::viewer())
}
