//! Planes anywhere, compared with the lesson's.

use crate::prelude::*;

pub fn check(check: &mut Check, new: &dyn Fn(Point3, Normal3) -> Made<Shape>) {
    compare(
        check,
        "plane through {}, normal {}",
        ([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]),
        |r| (r.triple(5.0), r.triple(5.0)),
        &|(a, n)| boxed(Plane::new(point(a), vector(n).as_normal())),
        &|(a, n)| new(point(a), vector(n).as_normal()),
    );
    let plane = new(point([0.0, -1.0, 0.0]), Normal3::new(0.0, 1.0, 0.0));
    scene(check, "scene-1", scene_1, plane);
    #[cfg(not(handout))]
    search(check, "plane", &|x| {
        new(
            Point3::new(x[0], x[1], x[2]),
            Normal3::new(x[3], x[4], x[5]),
        )
    });
}

variants! { check:
    yours => &|a, n| shape::boxed(Plane::new(a, n));
    right "the plane as n · p + k = 0" => &|a, n| {
        let n = n.unit("n")?;
        let k = -n.dot(a - Point3::ORIGIN);
        own(move |ray: &Ray, within| {
            let t = -(n.dot(ray.origin() - Point3::ORIGIN) + k) / n.dot(ray.direction());
            within.contains(t).then(|| Hit::new(t, n))
        })
    };
    wrong "a plane need not pass through the origin" => &|_, n| {
        boxed(Plane::new(Point3::ORIGIN, n))
    };
}
