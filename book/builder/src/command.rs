//! Runs other programs.

use std::process::Command;

/// Runs a program to its end. An error names the program.
pub fn run(command: &mut Command) -> Result<(), String> {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{} ended with {status}", name(command))),
        Err(error) => Err(not_started(command, &error)),
    }
}

/// What a program prints, if it succeeds.
pub fn output(command: &mut Command) -> Result<String, String> {
    match command.output() {
        Ok(output) if output.status.success() => {
            Ok(String::from_utf8_lossy(&output.stdout).into_owned())
        }
        Ok(output) => {
            let message = String::from_utf8_lossy(&output.stderr);
            Err(format!(
                "{} ended with {}\n{message}",
                name(command),
                output.status
            ))
        }
        Err(error) => Err(not_started(command, &error)),
    }
}

/// The words for a program that cannot be started.
pub fn not_started(command: &Command, error: &std::io::Error) -> String {
    format!("{} does not start: {error}", name(command))
}

fn name(command: &Command) -> String {
    command.get_program().to_string_lossy().into_owned()
}
