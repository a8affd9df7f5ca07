//! The intersection of a line and a plane.

use crate::line::Line;
use crate::number::{Number, Triple, difference, dot};

/// The `t` of a line at the plane through `point` that is perpendicular to `normal`.
pub fn t<N: Number>(point: &Triple<N>, normal: &Triple<N>, line: &Line<N>) -> N {
    dot(&difference(point, &line.origin), normal) / dot(&line.direction, normal)
}
