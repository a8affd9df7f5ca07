//! The intersection of a line and an axis-aligned box.

use crate::line::Line;
use crate::number::{Real, Triple};

/// The lesson's formula: the least positive `t` of a line that is in all three slabs at once, one
/// between each pair of faces.
///
/// For a line within a face, a quotient is no number. `min` and `max` drop it, and in this order the
/// slab changes nothing (Barnes, "Fast, Branchless Ray/Bounding Box Intersections, Part 2: NaNs",
/// 2015). The exit is wider by the rounding of both ends (Ize, "Robust BVH Ray Traversal", JCGT
/// 2(2), 2013).
pub fn slabs<F: Real>(least: &Triple<F>, greatest: &Triple<F>, line: &Line<F>) -> Option<F> {
    let zero = F::of(0.0);
    let (mut near, mut far) = (F::of(f64::NEG_INFINITY), F::of(f64::INFINITY));
    for axis in 0..3 {
        let inverse = F::of(1.0) / line.direction[axis];
        let a = (least[axis] - line.origin[axis]) * inverse;
        let b = (greatest[axis] - line.origin[axis]) * inverse;
        near = a.max(near).min(b.max(near));
        far = a.min(far).max(b.min(far));
    }
    let wider = F::of(1.0 + 4.0 * F::EPSILON);
    let last = if far < zero { far / wider } else { far * wider };
    if near > last {
        return None;
    }
    [near, far.max(near)].into_iter().find(|t| *t > zero)
}
