//! The errata page names rows of the stages' tables as its evidence.

use std::collections::HashSet;

use measure::Effort;

#[test]
fn every_row_that_the_errata_name_is_in_a_table() {
    let stages = [
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
    let rows: HashSet<_> = rows.map(|case| case.id).collect();

    let page = include_str!("../../../book/src/errata.md");
    let spans = page.split('`').skip(1).step_by(2);
    let named: Vec<_> = spans.filter(|span| is_row(span)).collect();
    assert!(named.len() > 50, "the page names its rows in code spans");
    for row in named {
        assert!(rows.contains(row), "there is no row {row}");
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
