//! Wrong solutions: with the barycentric coordinates of the plane's hit, and a condition.

use a02_math::{Direction, Normal3, Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use testing::exercise::{Check, Wrong};

use crate::triangle;

/// Whether the point of these barycentric coordinates is inside; and the normal, from the
/// cross product of ab and ac, and the direction of the ray.
#[derive(Debug)]
struct Triangle(
    [Point3; 3],
    fn(f64, f64) -> bool,
    fn(Vector3, Vector3) -> Option<Vector3>,
);

impl Geometry for Triangle {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let [a, b, c] = self.0;
        let (ab, ac, d, ao) = (b - a, c - a, ray.direction(), ray.origin() - a);
        let n = ab.cross(ac);
        let t = -ao.dot(n) / d.dot(n);
        let p = ao + d * t;
        let beta = p.cross(ac).dot(n) / n.dot(n);
        let gamma = ab.cross(p).dot(n) / n.dot(n);
        if !within.contains(t) || !(self.1)(beta, gamma) {
            return None;
        }
        let normal: Normal3 = (self.2)(n, d)?.as_normal();
        Some(Hit::new(t, normal))
    }
}

fn check(
    check: &mut Check,
    is_inside: fn(f64, f64) -> bool,
    normal: fn(Vector3, Vector3) -> Option<Vector3>,
) {
    triangle::check(check, |a, b, c| Ok(Triangle([a, b, c], is_inside, normal)));
}

fn inside(beta: f64, gamma: f64) -> bool {
    beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0
}

fn unit(n: Vector3, _: Vector3) -> Option<Vector3> {
    n.normalized()
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "a parallelogram",
        says: "beyond edge bc",
        check: |c| {
            check(
                c,
                |b, g| (0.0..=1.0).contains(&b) && (0.0..=1.0).contains(&g),
                unit,
            );
        },
    },
    Wrong {
        mistake: "the edges do not belong to the triangle",
        says: "on edge ab",
        check: |c| check(c, |b, g| b > 0.0 && g > 0.0 && b + g < 1.0, unit),
    },
    Wrong {
        mistake: "only two edges",
        says: "just outside edge ca",
        check: |c| check(c, |b, g| g >= 0.0 && b + g <= 1.0, unit),
    },
    Wrong {
        mistake: "the normal is not of length 1",
        says: "the normal, straight ahead",
        check: |c| check(c, inside, |n, _| Some(n)),
    },
    Wrong {
        mistake: "seen from the front only",
        says: "from the back",
        check: |c| check(c, inside, |n, d| n.normalized().filter(|n| n.dot(d) < 0.0)),
    },
];
