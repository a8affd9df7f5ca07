//! The table of all figures, and the table of the book.

use std::fmt::Write;

use crate::description::Description;
use crate::measurement::{Comparison, Figure};

pub const TRACE: Figure = |m| m.trace;
pub const TOTAL: Figure = |m| m.total;
pub const PEAK: Figure = |m| m.peak;
const BUILD: Figure = |m| m.build;

/// The names of the cells of a [`row`].
pub const HEADER: &str = "\
|         |         | build | trace |   MiB |   trace         |   total         |  memory         | different > 8 (mean of 255)   |
| scene   | threads |    ms |    ms |       | POV-Ray | Tachy | POV-Ray | Tachy | POV-Ray | Tachy |       POV-Ray |       Tachyon |
|---------|---------|-------|-------|-------|---------|-------|---------|-------|---------|-------|---------------|---------------|";

/// Our figures, and how many times as much the two others take.
pub fn row(comparison: &Comparison) -> String {
    let ours = |of, unit: f64| number(comparison.figure(0, of).map(|figure| figure / unit));
    let ratio = |i, of| number(comparison.ratio(i, of));
    let difference = |i: usize| match &comparison.differences[i] {
        Some(difference) => difference.to_string(),
        None => "-".to_owned(),
    };
    format!(
        "| {:7} | {:>7} | {:>5} | {:>5} | {:>5} | {:>7} | {:>5} | {:>7} | {:>5} | {:>7} | {:>5} | {:>13} | {:>13} |",
        comparison.description.name,
        comparison.threads,
        ours(BUILD, 1e-3),
        ours(TRACE, 1e-3),
        ours(PEAK, f64::from(1 << 20)),
        ratio(1, TRACE),
        ratio(2, TRACE),
        ratio(1, TOTAL),
        ratio(2, TOTAL),
        ratio(1, PEAK),
        ratio(2, PEAK),
        difference(1),
        difference(2),
    )
}

/// About three digits.
fn number(number: Option<f64>) -> String {
    match number {
        Some(number) if number >= 100.0 => format!("{number:.0}"),
        Some(number) if number >= 10.0 => format!("{number:.1}"),
        Some(number) if number.is_finite() => format!("{number:.2}"),
        _ => "-".to_owned(),
    }
}

/// The table of the book: the ratios of POV-Ray and Tachyon. A cell with two numbers is
/// for one thread and for two, any other for one.
pub fn of_book(comparisons: &[Comparison]) -> String {
    let mut text = "\
| | scene | trace: POV-Ray | Tachyon | total: POV-Ray | Tachyon | memory: POV-Ray | Tachyon |
|---|---|---:|---:|---:|---:|---:|---:|
"
    .to_owned();
    for of_scene in comparisons.chunk_by(|a, b| a.description.name == b.description.name) {
        let Description { name, about, .. } = of_scene[0].description;
        let cell = |comparisons: &[Comparison], i, of| {
            let ratios = comparisons.iter().filter_map(|c| c.ratio(i, of));
            let ratios: Vec<_> = ratios.map(|ratio| format!("{ratio:.1}")).collect();
            ratios.join(" / ")
        };
        let _ = write!(text, "| ![{name}](pictures/peers-{name}.png) | {about} ");
        for (comparisons, of) in [
            (of_scene, TRACE),
            (&of_scene[..1], TOTAL),
            (&of_scene[..1], PEAK),
        ] {
            for i in [1, 2] {
                let _ = write!(text, "| {} ", cell(comparisons, i, of));
            }
        }
        text += "|\n";
    }
    text
}
