//! The stiff and extreme cases of this stage: the rows of `cases.toml`, such as the light between two mirrors; and
//! here counts over many points, and worlds.

mod between_mirrors;
mod shadows;
mod tilted_floor;

use measure::Effort;
use measure::extremes::{Case, Row, rows};

pub fn cases(effort: Effort) -> Vec<Case> {
    rows(include_str!("../cases.toml"), effort, computed)
}

/// What a row asks, by our code and by the protocol's formula.
fn computed(row: &Row) -> Case {
    if let Some(question) = &row.ray {
        return shadows::under_a_ball_in_a_row(row, question);
    }
    match row.asks.as_str() {
        "mirrors" | "mirrors, ours" | "searches" | "lights" => between_mirrors::computed(row),
        "lamp above" => shadows::under_a_light(row.number(0)),
        "lamp" => shadows::under_a_light_at(row.triple(0)),
        "shadow rays" => shadows::rays_to_a_light_at(row.triple(0)),
        "lamp on a ceiling" => Case::of_wrong(shadows::under_a_ceiling(row.count)),
        "ball on a slope" => Case::of_wrong(shadows::under_a_ball(row.count, row.number(0))),
        "sun on a slope" => Case::of_wrong(shadows::under_the_sun(row.count)),
        _ => Row::unknown(),
    }
}
