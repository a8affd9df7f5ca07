//! Rays just inside and just outside of spheres, compared with the solution.

use crate::prelude::*;

yours! { may_meet }

type Code = fn(Point3, f64, &Ray) -> bool;

pub fn exercise() -> Exercise<Code> {
    Exercise::asked(|may_meet: &Code, (c, r, o, d)| {
        let meets = may_meet(point(c), r, &Ray::derived(point(o), vector(d)));
        Answer::named("a point within r", meets)
    })
}
