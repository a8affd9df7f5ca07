//! Rings anywhere, compared with the solution.

use crate::prelude::*;
use crate::solutions::ring::Ring;

pub fn check<G: Geometry>(
    check: &mut Check,
    new: impl Fn(Point3, Normal3, f64, f64) -> Result<G, ArgumentError>,
) {
    compare(
        check,
        "ring around {}, normal {}, from {} to {}",
        ([0.0; 3], [0.0, 1.0, 0.0], 1.0, 3.0),
        |r| {
            (
                r.triple(3.0),
                r.triple(5.0),
                r.between(0.5, 2.0),
                r.between(2.5, 4.0),
            )
        },
        |(c, n, hole, r)| Ring::new(point(c), vector(n).as_normal(), hole, r),
        |(c, n, hole, r)| new(point(c), vector(n).as_normal(), hole, r),
    );
    let saturn = || {
        let ring = new(Point3::ORIGIN, Normal3::new(0.3, 1.0, 0.1), 1.3, 2.2)?;
        Ok(World::new(Color::gray(0.05))?
            .with(
                Sphere::new(Point3::ORIGIN, 1.0)?,
                Color::new(0.9, 0.75, 0.5),
            )
            .with(ring, Color::gray(0.8)))
    };
    show_lit(check, saturn(), [1.0, 2.0, 6.0], [0.0; 3]);
}

/// The hits of the plane that are on the ring, by the squared distance, hole and radius.
fn variant(c: &mut Check, is_on_ring: fn(f64, f64, f64) -> bool) {
    check(c, move |c, n, hole, r| {
        let plane = Plane::new(c, n)?;
        own(move |ray: &Ray, within| {
            let hit = plane.hit(ray, within)?;
            let step = ray.at(hit.t) - c;
            is_on_ring(step.dot(step), hole, r).then_some(hit)
        })
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("the border of the hole belongs to the ring", |c| {
        variant(c, |squared, hole, r| {
            hole * hole < squared && squared <= r * r
        });
    }),
    wrong("the outer border belongs to the ring", |c| {
        variant(c, |squared, hole, r| {
            hole * hole <= squared && squared < r * r
        });
    }),
];
