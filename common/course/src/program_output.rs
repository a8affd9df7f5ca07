//! `output_of`: runs a program of the grader's own, which must succeed.

use std::process::Command;

use learn::files::with_path;

/// The output of a program. An error is all that it prints.
pub fn output_of(program: &mut Command) -> Result<Vec<u8>, String> {
    let name = program.get_program().to_owned();
    let output = program.output().map_err(with_path(name.as_ref()))?;
    if output.status.success() {
        return Ok(output.stdout);
    }
    let problem = [output.stdout, output.stderr].concat();
    Err(String::from_utf8_lossy(&problem).into_owned())
}
