//! The earlier reports about a program: a file beside the sheet's pictures, to which each report adds its lines.

use std::fmt::Write as _;
use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write as _};
use std::path::Path;

use super::precision::Report;
use crate::files::with_path;

const HEAD: &str = "report,samples,error,seconds,program\n";

/// The points of a report.
pub type Earlier = Vec<Point>;

/// A point of a report.
pub struct Point {
    pub samples: u32,
    pub error: f64,
    pub seconds: f64,
}

/// The reports about a program that a file has, from the first to the last; another line counts for nothing.
pub struct History {
    pub earlier: Vec<Earlier>,
    /// The number of the next report.
    next: u32,
}

impl History {
    pub fn read(file: &Path, program: &str) -> Result<Self, String> {
        let text = match fs::read_to_string(file) {
            Ok(text) => text,
            Err(error) if error.kind() == ErrorKind::NotFound => String::new(),
            Err(error) => return Err(with_path(file)(error)),
        };
        let mut history = Self {
            earlier: Vec::new(),
            next: 1,
        };
        let mut last = 0;
        for line in text.lines() {
            let Some((report, point)) = read(line, program) else {
                continue;
            };
            if report != last {
                history.earlier.push(Vec::new());
                last = report;
            }
            if let Some(earlier) = history.earlier.last_mut() {
                earlier.push(point);
            }
            history.next = history.next.max(report + 1);
        }
        Ok(history)
    }

    /// Adds a report to the file.
    pub fn add(&self, file: &Path, program: &str, report: &Report) -> Result<(), String> {
        let mut lines = String::new();
        if !file.exists() {
            lines += HEAD;
        }
        for point in &report.points {
            let (number, samples) = (self.next, point.samples);
            let (error, seconds) = (point.errors.rms, point.seconds.value);
            let _ = writeln!(lines, "{number},{samples},{error},{seconds},{program}");
        }
        let opened = OpenOptions::new().append(true).create(true).open(file);
        let written = opened.and_then(|mut file| file.write_all(lines.as_bytes()));
        written.map_err(with_path(file))
    }
}

/// A line about the program.
fn read(line: &str, program: &str) -> Option<(u32, Point)> {
    let mut cells = line.splitn(5, ',');
    let report = cells.next()?.parse().ok()?;
    let samples = cells.next()?.parse().ok()?;
    let error = cells.next()?.parse().ok()?;
    let seconds = cells.next()?.parse().ok()?;
    let point = Point {
        samples,
        error,
        seconds,
    };
    (cells.next()? == program).then_some((report, point))
}
