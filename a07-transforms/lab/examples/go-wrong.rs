//! The book's pictures of mistakes. Takes the arguments of the stages' programs.

use std::process::ExitCode;

fn main() -> ExitCode {
    command_line::run(&a07_lab::go_wrong::stage(), a01_image_display::viewer())
}
