//! `judge`: shows students the faults of their code.

use std::process::{ExitCode, exit};
use std::thread;
use std::time::Duration;

use super::findings::Findings;
use super::{Check, picture};

/// The longest time that a check may take.
const LONGEST: Duration = Duration::from_mins(1);

/// The exit code where nothing is judged.
const NOT_JUDGED: u8 = 3;

/// Runs the check of a student's file, prints the findings, and exits with 0 if the code
/// is right, with 1 if it is not, and with 3 if parts are still missing or it does not end.
#[must_use]
pub fn judge(stage: &str, name: &'static str, check: fn(&mut Check)) -> ExitCode {
    thread::spawn(move || {
        thread::sleep(LONGEST);
        println!("{name}: no end after {} seconds", LONGEST.as_secs());
        exit(NOT_JUDGED.into())
    });
    let found = Findings::of(check, true);
    if let Some(image) = found.picture {
        picture::save(&image, &format!("{stage}-{name}.png"));
    }
    if !found.missing.is_empty() {
        println!("to do: {}", found.missing.join("; "));
        return ExitCode::from(NOT_JUDGED);
    }
    for line in &found.wrong {
        println!("{}", readable(line));
    }
    ExitCode::from(u8::from(!found.wrong.is_empty()))
}

/// Digits of a number behind the point in a message.
const DIGITS: usize = 6;

/// A message in several lines, with numbers that are not longer than needed: small
/// differences are told by the error behind them.
fn readable(message: &str) -> String {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | 'e');
    let shortened = |piece: &str| {
        let number = piece.trim_end_matches(|c| !is_part(c));
        match number.parse::<f64>() {
            Ok(value) if number.len() > DIGITS + 2 => short(value) + &piece[number.len()..],
            _ => piece.to_owned(),
        }
    };
    let pieces = message.split_inclusive(|c| !is_part(c));
    let message: String = pieces.map(shortened).collect();
    message
        .replace("; ", "\n    ")
        .replace(": expected", "\n    expected")
}

fn short(value: f64) -> String {
    if value.abs() < 1e-3 {
        return format!("{value:.2e}");
    }
    let digits = format!("{value:.DIGITS$}");
    digits
        .trim_end_matches('0')
        .trim_end_matches('.')
        .to_owned()
}

#[cfg(test)]
mod tests {
    use super::readable;

    #[test]
    fn a_message_has_lines_and_short_numbers() {
        let message =
            "t; at 0.43789999999, 2: expected 1.25, got -3.000000000004e-7, off by 1.0e-9";
        let lines = "t\n    at 0.4379, 2\n    expected 1.25, got -3.00e-7, off by 1.0e-9";
        assert_eq!(readable(message), lines);
    }
}
