//! Tubes of many sizes, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, new: &dyn Fn(f64, f64) -> Made<Shape>) {
    compare(
        check,
        "tube of radius {} and height {}",
        (1.0, 2.0),
        |r| (r.between(0.1, 5.0), r.between(0.1, 9.0)),
        &|(r, height)| boxed(Cylinder::new(r, height)),
        &|(r, height)| new(r, height),
    );
    show(check, new(1.0, 2.0), [1.5, 4.5, 4.5], [0.0, 0.9, 0.0]);
}

variants! { check:
    yours => &|r, height| shape::boxed(Cylinder::new(r, height));
    wrong "rim and bottom belong to the tube" => &|r, height| {
        let tube = Cylinder::new(r, height)?;
        own(move |ray: &Ray, i| {
            let is_between = |y| 0.0 < y && y < height;
            tube.hit(ray, i).filter(|hit| is_between(ray.at(hit.t).y()))
        })
    };
}
