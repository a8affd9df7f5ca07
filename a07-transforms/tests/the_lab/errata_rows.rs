//! The rows of the tables of all stages have ids of their own, and the errata page names
//! them as its evidence.

use std::collections::HashSet;

use measure::Effort;

/// The ids of the rows of all stages.
fn ids() -> Vec<&'static str> {
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
    rows.map(|case| case.id).collect()
}

#[test]
fn no_two_rows_of_all_stages_have_the_same_id() {
    let ids = ids();
    let mut seen = HashSet::new();
    let twice: Vec<_> = ids.iter().filter(|id| !seen.insert(**id)).collect();
    assert!(twice.is_empty(), "{twice:?}");
    assert!(ids.len() > 300, "all stages have tables");
}

#[test]
fn every_row_that_the_errata_name_is_in_a_table() {
    let rows: HashSet<_> = ids().into_iter().collect();
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
