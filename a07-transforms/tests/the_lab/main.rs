//! Tests of `src/lab`: experiments, extreme cases, and the formulas that they measure.
//!
//! `cargo test` runs them after the tests of the lesson, which they measure.

use std::collections::HashSet;

use measure::Effort;

testing::check_lab! { a07_transforms::stage() }

/// The rows of the tables of all stages have ids of their own, and the errata page names
/// them as its evidence.
#[test]
fn ids_are_unique_and_the_errata_name_existing_rows() {
    let stages = [
        a01_image_display::stage(),
        a02_math::stage(),
        a03_rays_cameras::stage(),
        a04_intersections::stage(),
        a05_lighting::stage(),
        a06_shadows_reflection::stage(),
        a07_transforms::stage(),
    ];
    let rows = stages
        .iter()
        .flat_map(|stage| (stage.extremes)(Effort::Quick));
    let mut ids = HashSet::new();
    let twice: Vec<_> = rows
        .map(|row| row.id)
        .filter(|id| !ids.insert(*id))
        .collect();
    assert!(twice.is_empty(), "{twice:?}");
    assert!(ids.len() > 300, "all stages have tables");

    let page = include_str!("../../../book/src/errata.md");
    let spans = page.split('`').skip(1).step_by(2);
    let named: Vec<_> = spans.filter(|span| is_row(span)).collect();
    assert!(named.len() > 50, "the page names its rows in code spans");
    for row in named {
        assert!(ids.contains(row), "there is no row {row}");
    }
}

/// A letter, two digits, and perhaps another letter.
fn is_row(span: &str) -> bool {
    let bytes = span.as_bytes();
    matches!(bytes.len(), 3 | 4)
        && bytes[0].is_ascii_uppercase()
        && bytes[1..3].iter().all(u8::is_ascii_digit)
        && bytes[3..].iter().all(u8::is_ascii_lowercase)
}
