//! The experiments of the laboratory, and the extreme cases of all laboratories.

use std::collections::HashSet;
use std::fs;

use a06_lab::experiments::secondary_rays::NEAR;
use a06_lab::policy::offset;
use a07_lab::nested_nodes::lit_points;
use measure::Effort;
use measure::extremes::{Bound, Case, Condition};

testing::check_lab! { a07_lab::laboratory() }

/// Of four thousand points a condition, none has acne or a leak.
#[test]
fn points_under_nested_nodes_are_right() {
    for condition in [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9] {
        for trial in lit_points(4_096, 13, condition).unwrap() {
            assert!(!trial.shades_itself(offset), "acne, {condition}");
            assert!(!NEAR.iter().any(|near| trial.leaks(offset, *near)));
        }
    }
}

/// The extreme cases of all stages.
fn all_cases() -> Vec<Case> {
    let laboratories = [
        a01_lab::laboratory(),
        a02_lab::laboratory(),
        a03_lab::laboratory(),
        a04_lab::laboratory(),
        a05_lab::laboratory(),
        a06_lab::laboratory(),
        a07_lab::laboratory(),
    ];
    laboratories
        .iter()
        .flat_map(|laboratory| (laboratory.extremes)(Effort::Quick))
        .collect()
}

/// No bound is far above the condition of its case, but where a byte is computed.
#[test]
fn bounds_are_those_of_the_problem() {
    const OF_BYTES: [&str; 2] = ["L04", "Q13"];
    let mut loose = Vec::new();
    for case in all_cases() {
        let magnitude = case
            .exact
            .numbers()
            .iter()
            .fold(0.0, |a: f64, b| a.max(b.abs()));
        let ulps = match case.bound {
            Bound::Equal => 0.0,
            Bound::Ulps(ulps) => ulps,
            Bound::Absolute(bound) => bound / (f64::EPSILON * magnitude),
        };
        if let Condition::Known(condition) = case.condition
            && ulps > 16.0 * condition.max(1.0)
        {
            loose.push(case.id);
        }
    }
    loose.sort_unstable();
    assert_eq!(loose, OF_BYTES);
}

/// The rows of the tables of all stages have ids of their own, and the errata page names
/// them as its evidence.
#[test]
fn ids_are_unique_and_the_errata_name_existing_rows() {
    let mut ids = HashSet::new();
    for case in all_cases() {
        assert!(ids.insert(case.id.clone()), "{} stands twice", case.id);
    }
    assert!(ids.len() > 250, "all stages have tables");

    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/src/errata.md");
    let page = fs::read_to_string(page).unwrap();
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
