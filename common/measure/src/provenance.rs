//! `Provenance`: where the figures of a report come from.

use std::env::consts::{ARCH, OS};
use std::thread::available_parallelism;
use std::time::{SystemTime, UNIX_EPOCH};

/// The machine and the build that figures were measured on, and when, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Provenance {
    /// Processor, number of threads and system.
    pub machine: String,
    /// Version and profile of this program.
    pub version: String,
    /// The day in universal time, such as 2026-11-25.
    pub date: String,
    /// The number of rounds in which methods took turns.
    pub rounds: usize,
}

impl Provenance {
    /// This program on this machine, today.
    pub fn here(rounds: usize) -> Self {
        let cores = available_parallelism().map_or(1, usize::from);
        let profile = profile();
        let version = env!("CARGO_PKG_VERSION");
        Self {
            machine: format!("{}, {cores} threads, {OS}", processor()),
            version: format!("{version}, profile {profile}"),
            date: today(),
            rounds,
        }
    }
}

/// The profile of Cargo, after which it names the folder of a program.
fn profile() -> String {
    let program = std::env::current_exe().unwrap_or_default();
    let mut folders = program.components().rev().skip(1);
    let folder = folders.find(|folder| folder.as_os_str() != "deps");
    match folder.map(|folder| folder.as_os_str().to_string_lossy()) {
        Some(name) if name == "debug" => "dev".to_owned(),
        Some(name) => name.into_owned(),
        None => "unknown".to_owned(),
    }
}

/// The day of the system's clock.
fn today() -> String {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    date(since.map_or(0, |since| since.as_secs() / 86_400))
}

/// The day of this number in the Gregorian calendar; day 0 is 1970-01-01. Years begin in March here, so
/// that a leap day is the last of its year, and eras of 400 years are equally long. (H. Hinnant,
/// chrono-Compatible Low-Level Date Algorithms, 2013)
fn date(days: u64) -> String {
    let days = days + 719_468;
    let (era, of_era) = (days / 146_097, days % 146_097);
    let leap_days = of_era / 1_460 + of_era / 146_096 - of_era / 36_524;
    let year = (of_era - leap_days) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let (year, month) = if month < 10 {
        (year, month + 3)
    } else {
        (year + 1, month - 9)
    };
    format!("{:04}-{month:02}-{day:02}", 400 * era + year)
}

/// The model of the processor where the system names it, and otherwise its architecture.
fn processor() -> String {
    match model_on_linux().or_else(model_on_windows) {
        Some(model) => format!("{model} ({ARCH})"),
        None => ARCH.to_owned(),
    }
}

fn model_on_linux() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    for line in text.lines() {
        if let Some((name, value)) = line.split_once(':')
            && name.trim() == "model name"
        {
            return Some(value.trim().to_owned());
        }
    }
    None
}

fn model_on_windows() -> Option<String> {
    std::env::var("PROCESSOR_IDENTIFIER").ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_are_those_of_the_calendar() {
        let days = [0, 59, 11_016, 11_017, 20_782];
        let dates = [
            "1970-01-01",
            "1970-03-01",
            "2000-02-29",
            "2000-03-01",
            "2026-11-25",
        ];
        assert_eq!(days.map(date), dates);
    }
}
