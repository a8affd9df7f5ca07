//! Tori of many sizes, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, new: &dyn Fn(f64, f64) -> Made<Shape>) {
    compare(
        check,
        "circle of radius {}, tube of radius {}",
        (2.0, 0.5),
        |r| (r.between(2.0, 5.0), r.between(0.5, 1.5)),
        &|(ring, r)| boxed(Torus::new(ring, r)),
        &|(ring, r)| new(ring, r),
    );
    show(check, new(2.0, 0.5), [2.0, 5.0, 7.0], [0.0, -0.2, 0.0]);
}

variants! { check:
    yours => &|ring, r| shape::boxed(Torus::new(ring, r));
    wrong "fixed steps pass over what is thinner" => &|ring, r| {
        let torus = Torus::new(ring, r)?;
        own(move |ray: &Ray, i| {
            let hit = torus.hit(ray, i)?;
            // In and out again within a quarter of the radius.
            let max = hit.t + r / 4.0 / ray.direction().magnitude();
            let next = torus.hit(ray, Interval { min: hit.t, max });
            next.is_none().then_some(hit)
        })
    };
}
