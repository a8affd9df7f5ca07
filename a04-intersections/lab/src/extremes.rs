//! Stiff and extreme cases of rays and shapes: the rows of `cases.toml`, and the functions that count over many rays
//! or have a formula of their own.

mod coincident;
mod leaks;
mod plane;
mod precision;
mod sphere;
mod triangle;

use a02_math::Point3;
use common::{ArgumentError, Color, Transfer};
use measure::Effort;
use measure::extremes::{Case, Outcome, Row, tried};

use crate::closed_mesh::Aim;
use crate::line::Line;
use crate::support::first;
use crate::{protocol, rows};
use a04_intersections::Geometry;

/// The rows that are numbers in, a number out.
const ROWS: &str = include_str!("../cases.toml");

pub fn cases(effort: Effort) -> Vec<Case> {
    let mut cases = measure::extremes::rows(ROWS, effort, computed);
    cases.sort_by(|a, b| a.id.cmp(&b.id));
    cases
}

const EPSILON: f64 = f64::EPSILON;

/// The `t` of the nearest hit as an outcome, or the error of a constructor.
fn nearest_hit<G: Geometry>(shape: Result<G, ArgumentError>, line: Line) -> Outcome {
    tried(|| Ok(first(&shape?, &line.unit_ray()?)))
}

/// What a row asks, by our code and by the protocol's formula.
fn computed(row: &Row) -> Case {
    if let Some(question) = &row.ray {
        let shapes = rows::described(&question.shape);
        return shapes.map_or_else(Row::unknown, |shapes| rows::met(shapes, row, question));
    }
    match row.asks.as_str() {
        "byte" => {
            let [ours, ..] = Transfer::Linear.bytes(Color::gray(row.number(0)));
            Case::of(f64::from(ours), f64::from(protocol::byte(row.number(0))))
        }
        "finite" => Case::of_ours(Color::gray(f64::NAN).is_finite()),
        "from inside" => sphere::seen_from_inside(),
        "root of a miss" => sphere::root_of_a_miss(),
        "far sphere" => precision::wrong_hits(row.number(0), row.count),
        "moved" => precision::moved(row.count),
        "scaled" => precision::scaled(row.count),
        "corners on a line" => Case::of_wrong(triangle::noise(row.count)),
        "mean of normals" => triangle::mean_of_normals(),
        "points within" => triangle::points_within(row.count),
        "leaving" => Case::of_wrong(plane::leaving(row.count)),
        "coincident" => Case::of_ours(coincident::greatest_difference(row.count)),
        "mesh at corners" => leaks::mesh(Point3::ORIGIN, Aim::Corners, row.count),
        "mesh at edges" => leaks::mesh(Point3::ORIGIN, Aim::Edges, row.count),
        "mesh anywhere" => leaks::mesh(Point3::ORIGIN, Aim::Anywhere, row.count),
        "far mesh at corners" => leaks::mesh(leaks::FAR, Aim::Corners, row.count),
        "box" => leaks::at_a_box(row.number(0) as usize, row.number(1) as usize, row.count),
        _ => Row::unknown(),
    }
}
