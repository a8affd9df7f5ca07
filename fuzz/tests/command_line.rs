//! The command line, with inputs that are the same every time.

use std::env;
use std::process::Command;

use fuzz::command_line;
use fuzz::inputs::check_near;

/// Set in the process that runs the programs: their messages are not output of a
/// test, and they change the folder.
const INSIDE: &str = "FUZZ_COMMAND_LINE";

#[test]
fn command_lines_do_no_harm() {
    if env::var_os(INSIDE).is_some() {
        return check_near("command_line", 2000, command_line::check);
    }
    let mut test = Command::new(env::current_exe().expect("this test"));
    let output = test.env(INSIDE, "").arg("--nocapture").output();
    let output = output.expect("the test runs");
    let said = String::from_utf8_lossy(&output.stderr);
    let panicked = said.find("panicked at").map(|start| &said[start..]);
    assert!(output.status.success(), "{}", panicked.unwrap_or(&said));
}
