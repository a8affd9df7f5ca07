//! Box tests for rays that aim at faces, edges and corners.

use a02_math::Point3;
use a02_math::arrays::{array, point};
use a03_rays_cameras::Ray;

use crate::protocol::{self, Compared};
use crate::support::Numbers;

/// The corners of the box: numbers that no double holds exactly.
pub const LBF: Point3 = Point3::new(0.1, 0.2, 0.3);
pub const RUN: Point3 = Point3::new(0.7, 1.1, 0.9);

/// A ray towards a visible point of the box, from beyond the right, upper, near corner.
pub struct Aimed {
    pub ray: Ray,
    /// The distance of the point.
    pub distance: f64,
}

impl Aimed {
    /// The `n`-th ray towards a point on `faces` faces at once: 1 for a point inside a
    /// face, 2 for a point on an edge, 3 for a corner.
    pub fn new(faces: usize, n: usize) -> Self {
        let mut numbers = Numbers::new(21, n);
        let eye = RUN + numbers.triple(0.5, 3.0);
        let (low, high) = (array(LBF), array(RUN));
        let seen = numbers.below(3);
        let at_border = (seen + 1 + numbers.below(2)) % 3;
        let mut target = [0.0; 3];
        for axis in 0..3 {
            target[axis] = if axis == seen {
                high[axis]
            } else if faces == 3 || (faces == 2 && axis == at_border) {
                [low, high][numbers.below(2)][axis]
            } else {
                numbers.between(low[axis], high[axis])
            };
        }
        let towards = point(target) - eye;
        let distance = towards.magnitude();
        let ray = Ray::derived(eye, towards * (1.0 / distance));
        Self { ray, distance }
    }

    /// Whether a result is no hit, or a hit at another point, on the far side for example.
    pub fn is_wrong(&self, t: Option<f64>) -> bool {
        t.is_none_or(|t| (t - self.distance).abs() > 1e-9)
    }
}

/// A formula for the nearest hit of the box.
pub struct Formula {
    pub name: &'static str,
    pub t: fn(&Ray) -> Option<f64>,
}

/// The formulas of others.
pub const OTHERS: [Formula; 2] = [
    Formula {
        name: "three coordinates compared",
        t: |ray| protocol::axis_aligned_box(LBF, RUN, ray, Compared::Three),
    },
    Formula {
        name: "two coordinates compared",
        t: |ray| protocol::axis_aligned_box(LBF, RUN, ray, Compared::Two),
    },
];
