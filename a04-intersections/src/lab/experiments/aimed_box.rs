//! Box tests for rays that aim at faces, edges and corners.

use std::rc::Rc;

use a02_math::Point3;
use a03_rays_cameras::Ray;
use measure::Effort;
use measure::experiment::{Axis, Curve, Experiment, Unit, share};

use super::Numbers;
use crate::lab::extremes::arrays;
use crate::lab::protocol::{self, Compared};
use crate::{AxisAlignedBox, Geometry, Interval};

/// The corners of the box: numbers that no double holds exactly.
pub const LBF: Point3 = Point3::new(0.1, 0.2, 0.3);
pub const RUN: Point3 = Point3::new(0.7, 1.1, 0.9);

/// A ray towards a visible point of the box.
pub struct Aimed {
    /// The ray, from beyond the right, upper, near corner.
    pub ray: Ray,
    pub distance: f64,
}

/// The `n`-th ray towards a point on `faces` faces at once: 1 for a point inside a
/// face, 2 for a point on an edge, 3 for a corner.
pub fn aimed(faces: usize, n: usize) -> Aimed {
    let mut numbers = Numbers::new(21, n);
    let eye = RUN + numbers.triple(0.5, 3.0);
    let (low, high) = (LBF.to_glam().to_array(), RUN.to_glam().to_array());
    let seen = numbers.below(3);
    let at_border = (seen + 1 + numbers.below(2)) % 3;
    let aim: [f64; 3] = std::array::from_fn(|axis| {
        if axis == seen {
            high[axis]
        } else if faces == 3 || (faces == 2 && axis == at_border) {
            [low, high][numbers.below(2)][axis]
        } else {
            numbers.between(low[axis], high[axis])
        }
    });
    let way = Point3::from_glam(aim.into()) - eye;
    let distance = way.magnitude();
    Aimed {
        ray: Ray::derived(eye, way * (1.0 / distance)),
        distance,
    }
}

impl Aimed {
    /// Whether a result is no hit, or a hit at another point, on the far side for
    /// example.
    pub fn is_wrong(&self, t: Option<f64>) -> bool {
        t.is_none_or(|t| (t - self.distance).abs() > 1e-9)
    }
}

/// The protocol's box, comparing all coordinates.
pub fn three(ray: &Ray) -> Option<f64> {
    protocol::axis_aligned_box(LBF, RUN, ray, Compared::Three)
}

/// The protocol's box, comparing two coordinates.
pub fn two(ray: &Ray) -> Option<f64> {
    protocol::axis_aligned_box(LBF, RUN, ray, Compared::Two)
}

/// Naive slabs: no margin for rounding, and NaN for a ray in the plane of a face.
pub fn slabs(lbf: Point3, run: Point3, ray: &Ray) -> Option<f64> {
    let [low, high] = [lbf, run].map(|p| p.to_glam().to_array());
    let [o, d] = arrays(ray);
    let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        let inverse = 1.0 / d[axis];
        let a = (low[axis] - o[axis]) * inverse;
        let b = (high[axis] - o[axis]) * inverse;
        near = near.max(a.min(b));
        far = far.min(a.max(b));
    }
    let is_hit = !(near > far || far < 0.0);
    is_hit.then_some(if near >= 0.0 { near } else { far })
}

fn curve(
    method: &'static str,
    aims: &[(f64, Rc<[Aimed]>)],
    formula: impl Fn(&Ray) -> Option<f64> + Copy + 'static,
) -> Curve<'static> {
    let wrong = |aims: &[_]| share(aims, |aimed: &&Aimed| aimed.is_wrong(formula(&aimed.ray)));
    let run = move |aimed: &Aimed| formula(&aimed.ray).unwrap_or_default();
    Curve::of_tasks(method, aims, wrong, run)
}

fn curves(effort: Effort) -> Vec<Curve<'static>> {
    let count = effort.choose(4096, 65_536);
    let aims = |faces| (0..count).map(|n| aimed(faces, n)).collect();
    let aims = [(1.0, aims(1)), (2.0, aims(2)), (3.0, aims(3))];
    // The arguments are constants that the constructor accepts.
    let ours = AxisAlignedBox::new(LBF, RUN).ok();
    let ours = move |ray: &Ray| ours?.hit(ray, Interval::AHEAD).map(|hit| hit.t);
    vec![
        curve("protocol (three)", &aims, three),
        curve("protocol (two)", &aims, two),
        curve("naive slabs", &aims, |ray| slabs(LBF, RUN, ray)),
        curve("slabs (ours)", &aims, ours)
            .with_remark("also says which face was met, for the normal"),
    ]
}

pub fn experiment() -> Experiment<'static> {
    Experiment {
        name: "box-aimed",
        about: "Who loses rays at the edges and corners of a box?",
        knob: "faces aimed at",
        work: "tests",
        error: "share of wrong answers",
        unit: Unit::Share,
        exact: "a miss, or a hit elsewhere; aimed at a face, at an edge of two, at a corner of three",
        seeds: &[21],
        against: Axis::Knob,
        curves: Box::new(curves),
    }
}
