//! The experiments and extreme cases of all laboratories, and the arithmetic, formulas and meshes by which they
//! measure.

mod closed_mesh;
mod corpus;
mod double_double;
mod formulas;
mod mirroring_ball;
mod nested_nodes;

use std::collections::HashSet;
use std::fs;
use std::sync::LazyLock;

use measure::extremes::{Bound, Case, Condition};
use measure::{Effort, Laboratory, experiment, extremes};

fn laboratories() -> [Laboratory; 7] {
    [
        a01_lab::laboratory(),
        a02_lab::laboratory(),
        a03_lab::laboratory(),
        a04_lab::laboratory(),
        a05_lab::laboratory(),
        a06_lab::laboratory(),
        a07_lab::laboratory(),
    ]
}

/// The extreme cases of all stages.
static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| {
    let laboratories = laboratories();
    let cases = laboratories
        .iter()
        .flat_map(|laboratory| (laboratory.extremes)(Effort::of_build()));
    cases.collect()
});

/// The curves have the slopes and bounds of theory.
#[test]
fn the_experiments_agree_with_theory() {
    for laboratory in laboratories() {
        for experiment in (laboratory.experiments)() {
            experiment::check(&experiment);
        }
    }
}

#[test]
fn the_extreme_cases_hold() {
    extremes::check(&CASES);
}

/// No bound is far above the condition of its case, but where a byte is computed, and where a spot light compares the
/// cosine of a small angle.
#[test]
fn bounds_are_those_of_the_problem() {
    const LOOSE: [&str; 5] = ["F41", "F42", "F43", "L04", "Q13"];
    let mut loose = Vec::new();
    for case in CASES.iter() {
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
            loose.push(case.id.as_str());
        }
    }
    loose.sort_unstable();
    assert_eq!(loose, LOOSE);
}

/// The rows of the tables of all stages have ids of their own, and the errata page names
/// them as its evidence.
#[test]
fn ids_are_unique_and_the_errata_name_existing_rows() {
    let mut ids = HashSet::new();
    for case in CASES.iter() {
        assert!(ids.insert(case.id.as_str()), "{} stands twice", case.id);
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
