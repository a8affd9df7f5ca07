//! Box tests for rays that aim at faces, edges and corners.

use a02_math::Point3;
use a02_math::arrays::array;
use a03_rays_cameras::Ray;

use crate::protocol::{self, Compared};
use crate::support::{Numbers, arrays};

/// The corners of the box: numbers that no double holds exactly.
pub const LBF: Point3 = Point3::new(0.1, 0.2, 0.3);
pub const RUN: Point3 = Point3::new(0.7, 1.1, 0.9);

/// A ray towards a visible point of the box, from beyond the right, upper, near corner; and
/// the distance of the point.
pub type Aimed = (Ray, f64);

/// The `n`-th ray towards a point on `faces` faces at once: 1 for a point inside a
/// face, 2 for a point on an edge, 3 for a corner.
pub fn aimed(faces: usize, n: usize) -> Aimed {
    let mut numbers = Numbers::new(21, n);
    let eye = RUN + numbers.triple(0.5, 3.0);
    let (low, high) = (array(LBF), array(RUN));
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
    (Ray::derived(eye, way * (1.0 / distance)), distance)
}

/// Whether a result is no hit, or a hit at another point, on the far side for example.
pub fn is_wrong((_, distance): &Aimed, t: Option<f64>) -> bool {
    t.is_none_or(|t| (t - distance).abs() > 1e-9)
}

/// A formula for the nearest hit of the box.
pub type Formula = fn(&Ray) -> Option<f64>;

/// The protocol's box, comparing all coordinates or two, and naive slabs.
pub const NAIVE: [Formula; 3] = [
    |ray| protocol::axis_aligned_box(LBF, RUN, ray, Compared::Three),
    |ray| protocol::axis_aligned_box(LBF, RUN, ray, Compared::Two),
    |ray| slabs(LBF, RUN, ray),
];

/// Naive slabs: no margin for rounding, and NaN for a ray in the plane of a face.
pub fn slabs(lbf: Point3, run: Point3, ray: &Ray) -> Option<f64> {
    let [low, high] = [lbf, run].map(array);
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
