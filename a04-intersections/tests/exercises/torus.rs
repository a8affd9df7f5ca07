//! Tori of many sizes, compared with the solution.

use crate::prelude::*;
use crate::solutions::torus::Torus;

pub fn check<G: Geometry>(check: &mut Check, new: impl Fn(f64, f64) -> Result<G, ArgumentError>) {
    compare(
        check,
        "circle of radius {}, tube of radius {}",
        (2.0, 0.5),
        |r| (r.between(2.0, 5.0), r.between(0.5, 1.5)),
        |(ring, r)| Torus::new(ring, r),
        |(ring, r)| new(ring, r),
    );
    show(check, new(2.0, 0.5), [2.0, 5.0, 7.0], [0.0, -0.2, 0.0]);
}

/// The right torus, with a flaw in its hits; the tube's radius, and the length of a step.
fn variant(c: &mut Check, flaw: fn(&Torus, f64, &Ray, Interval) -> Option<Hit>) {
    check(c, move |ring, r| {
        let torus = Torus::new(ring, r)?;
        own(move |ray: &Ray, within| flaw(&torus, r / ray.direction().magnitude(), ray, within))
    });
}

pub const VARIANTS: &[Variant] = &[
    wrong("fixed steps pass over what is thinner", |c| {
        variant(c, |torus, r, ray, i| {
            let hit = torus.hit(ray, i)?;
            let next = torus.hit(ray, Interval { min: hit.t, ..i });
            // In and out again within a quarter of the radius.
            Some(hit).filter(|hit| next.is_none_or(|next| next.t - hit.t > r / 4.0))
        });
    }),
    wrong("within the tube the distance is negative", |c| {
        variant(c, |torus, _, ray, i| {
            torus
                .hit(ray, i)
                .filter(|hit| hit.normal.dot(ray.direction()) < 0.0)
        });
    }),
];
