//! `ComparedShape`: a shape that some numbers describe, with the lesson's formula and the protocol's.

use a02_math::Normal3;
use a02_math::arrays::{point, vector};
use a03_rays_cameras::Ray;
use measure::extremes::{Case, Refused};

use crate::formula::sphere::SphereQuery;
use crate::line::Line;
use crate::protocol::{self, Compared};
use crate::support::{Triple, first};
use a04_intersections::{AxisAlignedBox, Geometry, Plane, Sphere, Triangle};

/// A shape that some numbers describe.
pub struct ComparedShape {
    /// The shape of these numbers, unless its constructor refuses them.
    pub make: fn(&[f64]) -> Option<Box<dyn Geometry>>,
    /// The `t` of the nearest hit by the protocol's formula.
    pub protocol: fn(&[f64], &Ray) -> Option<f64>,
}

/// Its centre and its radius.
pub const SPHERE: ComparedShape = ComparedShape {
    make: |x| Some(Box::new(Sphere::new(point(triple(x)), x[3]).ok()?)),
    protocol: |x, ray| {
        protocol::sphere(&SphereQuery {
            center: triple(x),
            radius: x[3],
            line: Line::of(ray),
        })
    },
};

/// One of its points, and its normal.
pub const PLANE: ComparedShape = ComparedShape {
    make: |x| {
        let normal = vector(triple(&x[3..])).as_normal();
        Some(Box::new(Plane::new(point(triple(x)), normal).ok()?))
    },
    protocol: |x, ray| protocol::plane(point(triple(x)), unit_normal(x), ray),
};

/// Two opposite corners.
pub const BOX: ComparedShape = ComparedShape {
    make: |x| {
        let [a, b] = [triple(x), triple(&x[3..])].map(point);
        Some(Box::new(AxisAlignedBox::new(a, b).ok()?))
    },
    protocol: |x, ray| {
        let [low, high] = [triple(x), triple(&x[3..])].map(point);
        protocol::axis_aligned_box(low, high, ray, Compared::Three)
    },
};

/// Its corners.
pub const TRIANGLE: ComparedShape = ComparedShape {
    make: |x| {
        let [a, b, c] = corners(x).map(point);
        Some(Box::new(Triangle::new(a, b, c).ok()?))
    },
    protocol: |x, ray| protocol::triangle(&corners(x).map(point), ray),
};

/// The first three numbers.
pub fn triple(x: &[f64]) -> Triple {
    [x[0], x[1], x[2]]
}

fn corners(x: &[f64]) -> [Triple; 3] {
    [0, 3, 6].map(|corner| triple(&x[corner..]))
}

/// The normal of a plane or disc, of length 1 where this is possible.
pub fn unit_normal(x: &[f64]) -> Normal3 {
    let n = vector(triple(&x[3..]));
    n.normalized().unwrap_or(n).as_normal()
}

impl ComparedShape {
    /// The nearest hit of a ray by the lesson's formula and the protocol's. The row lacks its words.
    pub fn met(&self, numbers: &[f64], line: Line) -> Case {
        let theirs = (self.protocol)(numbers, &line.any_ray());
        match ((self.make)(numbers), line.unit_ray()) {
            (Some(shape), Ok(ray)) => Case::of(first(&*shape, &ray), theirs),
            _ => Case::of(Refused, theirs),
        }
    }

    /// The `t` of the nearest hit by the lesson's formula.
    pub fn lesson(&self, numbers: &[f64], ray: &Ray) -> Option<f64> {
        first(&*(self.make)(numbers)?, ray)
    }
}
