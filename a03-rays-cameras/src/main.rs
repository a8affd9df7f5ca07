//! Shows the pictures of assignment 3.

#![cfg_attr(target_family = "wasm", no_main)]

#[cfg(not(target_family = "wasm"))]
fn main() -> std::process::ExitCode {
    command_line::run(&a03_rays_cameras::stage(), a01_image_display::viewer())
}
