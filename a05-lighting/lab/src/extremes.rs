//! The stiff and extreme cases of this stage: the rows of `cases.toml`, such as far lights, points at the edge of a
//! cone, and powers from 0 to overflow; and here counts over many rays, and colours by formulas of their own.

mod lights;
mod materials;
mod spots;

use a02_math::arrays::vector;
use measure::Effort;
use measure::extremes::{AgainstProtocol, Case, Row, rows};

use crate::protocol;
use crate::sweeps::edge;

pub fn cases(effort: Effort) -> Vec<Case> {
    rows(include_str!("../cases.toml"), effort, computed)
}

/// What a row asks, by our code and by the protocol's formula.
fn computed(row: &Row) -> Case {
    match row.asks.as_str() {
        "spot" => spots::lights(row.triple(0), row.number(3), row.triple(4)),
        "angle by the cosine" => {
            let [a, b] = [0, 3].map(|index| vector(row.triple(index)));
            Case::of(a.angle(b), protocol::angle(a, b))
        }
        "radius of light" => {
            let AgainstProtocol { ours, theirs } = edge(row.number(0));
            Case::of(ours, theirs)
        }
        "highlight" => materials::power(row.number(0), row.number(1)),
        "lamp" => lights::under_a_lamp(row.number(0)),
        "lamp in a sphere" => lights::from_height(row.number(0)),
        "sun" => lights::in_the_sun(row.triple(0), row.number(3), row.number(4)),
        "spots, behind" => spots::lit_behind(row.count),
        "angles" => spots::angles(row.count),
        "sun at the origin" => lights::sun_at_the_origin(),
        "highlight from behind" => materials::highlight_from_behind(),
        "two lights" => materials::two_lights(),
        "highlight on red" => materials::highlight_on_red(),
        "bright light" => materials::under_a_light(0.25, 3.0, protocol::clamped_product),
        "dim light" => materials::under_a_light(0.1, 0.1, protocol::integer_product),
        _ => Row::unknown(),
    }
}
