//! Where the figures of a report come from: machine, compiler, version and date.

use std::env::consts::{ARCH, OS};
use std::thread::available_parallelism;
use std::time::{SystemTime, UNIX_EPOCH};

/// The lines of the head of a report, each a name with its value.
pub fn lines() -> [(&'static str, String); 4] {
    let cores = available_parallelism().map_or(1, usize::from);
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    let date = date(now.map_or(0, |now| now.as_secs()));
    [
        ("machine", format!("{}, {cores} threads, {OS}", processor())),
        ("compiler", env!("COMPILER").trim().to_owned()),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("date", date),
    ]
}

/// The model of the processor where the system names it, and otherwise its architecture.
fn processor() -> String {
    let of_linux = || {
        let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
        let mut lines = text.lines().filter_map(|line| line.split_once(':'));
        let (_, model) = lines.find(|(name, _)| name.trim() == "model name")?;
        Some(model.trim().to_owned())
    };
    let of_windows = || std::env::var("PROCESSOR_IDENTIFIER").ok();
    let model = of_linux().or_else(of_windows);
    model.map_or(ARCH.to_owned(), |model| format!("{model} ({ARCH})"))
}

/// The date and time in UTC of some seconds since the start of 1970. (H. Hinnant,
/// chrono-Compatible Low-Level Date Algorithms: years begin in March, so that the leap day
/// is the last one.)
fn date(seconds: u64) -> String {
    let days = seconds / 86_400 + 719_468;
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let day = day - (153 * month + 2) / 5 + 1;
    let year = year + era * 400 + month / 10;
    let month = (month + 2) % 12 + 1;
    let (hour, minute) = (seconds / 3600 % 24, seconds / 60 % 60);
    format!("{year}-{month:02}-{day:02} {hour:02}:{minute:02} UTC")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seconds_become_dates() {
        for (seconds, expected) in [
            (0, "1970-01-01 00:00 UTC"),
            (951_782_400, "2000-02-29 00:00 UTC"),
            (1_709_164_799, "2024-02-28 23:59 UTC"),
            (4_107_542_400, "2100-03-01 00:00 UTC"),
        ] {
            assert_eq!(date(seconds), expected);
        }
    }
}
