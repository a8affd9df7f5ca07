//! The order of a chain of transforms: rotated and then moved, moved and then rotated.

use a07_transforms::Transform;

use super::{Answered, place, point};
use crate::Reply;

/// The corners of the shape, a flag.
const FLAG: [(f64, f64); 5] = [(0.0, 0.0), (0.0, 1.0), (0.7, 0.8), (0.0, 0.6), (0.0, 0.0)];

/// Numbers: an angle in degrees and a translation.
pub fn answer([angle, x, y]: [f64; 3]) -> Answered {
    let (angle, by) = (angle.to_radians(), point(x, y));
    let turned_first = Transform::IDENTITY.translate(by)?.rotate_z(angle)?;
    let moved_first = Transform::IDENTITY.rotate_z(angle)?.translate(by)?;
    let flag = |transform: Transform| {
        let corners = FLAG.into_iter();
        corners.flat_map(move |(x, y)| place(transform.matrix() * point(x, y)))
    };
    Ok(Reply::default()
        .with("turned_first", flag(turned_first))
        .with("moved_first", flag(moved_first)))
}
