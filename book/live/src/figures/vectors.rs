//! Two vectors: their products, their angle, a projection and a reflection.

use a02_math::{Direction, Vector3};

use super::flat;
use crate::Reply;

/// Numbers: the vectors a and b, in the plane of the figure. The reflection is of a, on a
/// surface with the normal b. Angles are in degrees.
pub fn answer([ax, ay, bx, by]: [f64; 4]) -> Reply {
    let (a, b) = (Vector3::new(ax, ay, 0.0), Vector3::new(bx, by, 0.0));
    let projection = a.projected_on(b);
    let reflected = b.normalized().map(|n| a.reflected_on(n.as_normal()));
    Reply::default()
        .with("dot", [a.dot(b)])
        .with("cosine", [a.dot(b) / (a.magnitude() * b.magnitude())])
        .with("cross", a.cross(b).to_glam().to_array())
        .with("area", [a.parallelogram_area(b)])
        .with("angle", [a.angle(b).to_degrees()])
        .with("projection", projection.into_iter().flat_map(flat))
        .with("reflected", reflected.into_iter().flat_map(flat))
}
