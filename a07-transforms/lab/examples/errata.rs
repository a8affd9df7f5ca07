//! The pictures of the book's errata. Takes the arguments of the stages' programs.

use std::process::ExitCode;

fn main() -> ExitCode {
    command_line::run(&a07_lab::errata::stage(), a01_image_display::viewer())
}
