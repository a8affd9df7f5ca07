//! The stiff and extreme cases of this stage: the rows of `cases.toml`, such as balls under transforms; and here
//! counts over many rays, and nodes of several objects.

mod discs;
pub mod matrices;
mod nodes;

use corpus::Shape;
use measure::Effort;
use measure::extremes::{Case, Row, rows};

pub fn cases(effort: Effort) -> Vec<Case> {
    rows(include_str!("../cases.toml"), effort, computed)
}

/// What a row asks, by our code and by the protocol's formula.
fn computed(row: &Row) -> Case {
    let Some(question) = &row.ray else {
        return match row.asks.as_str() {
            "two balls" => nodes::nearer_child(row.number(0), row.number(1)),
            "leaving a disc" => Case::of_wrong(discs::leaving(row.count)),
            "brightness" => nodes::brightness_under_scale(),
            "turned normal" => nodes::turned_normal(),
            _ => matrices::computed(row),
        };
    };
    match (row.asks.as_str(), &question.shape) {
        ("normal", _) => nodes::of_normal(row, question),
        (_, Shape::Disc { .. }) => discs::met(row, question),
        _ => nodes::of_ellipsoid(question),
    }
}
