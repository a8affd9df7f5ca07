//! Rings anywhere, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, new: &dyn Fn(Point3, Normal3, f64, f64) -> Made<Shape>) {
    compare(
        check,
        "ring around {}, normal {}, from {} to {}",
        ([0.0; 3], [0.0, 1.0, 0.0], 1.0, 3.0),
        |r| {
            let (hole, width) = (r.between(0.5, 2.0), r.between(0.5, 2.0));
            (r.triple(3.0), r.triple(5.0), hole, hole + width)
        },
        &|(c, n, hole, r)| boxed(Ring::new(point(c), vector(n).as_normal(), hole, r)),
        &|(c, n, hole, r)| new(point(c), vector(n).as_normal(), hole, r),
    );
    let saturn = || {
        let ring = new(Point3::ORIGIN, Normal3::new(0.3, 1.0, 0.1), 1.3, 2.2)?;
        let planet = Sphere::new(Point3::ORIGIN, 1.0)?;
        let world = World::new(Color::gray(0.05))?.with(ring, Color::gray(0.8));
        Ok(world.with(planet, Color::new(0.9, 0.75, 0.5)))
    };
    show_lit(check, saturn(), [1.0, 2.0, 6.0], [0.0; 3]);
}

variants! { check:
    yours => &|c, n, hole, r| shape::boxed(Ring::new(c, n, hole, r));
    wrong "both borders belong to the ring" => &|c, n, hole, r| {
        let ring = Ring::new(c, n, hole, r)?;
        own(move |ray: &Ray, i| {
            let hit = ring.hit(ray, i)?;
            let distance = (ray.at(hit.t) - c).magnitude();
            (hole < distance && distance < r).then_some(hit)
        })
    };
}
