//! Spheres anywhere, compared with the lesson's.

use crate::prelude::*;

pub fn check(check: &mut Check, new: &dyn Fn(Point3, f64) -> Made<Shape>) {
    compare(
        check,
        "sphere around {} of radius {}",
        ([0.0, 0.0, 0.0], 1.0),
        |r| (r.triple(5.0), r.between(0.2, 4.0)),
        &|(c, r)| boxed(Sphere::new(point(c), r)),
        &|(c, r)| new(point(c), r),
    );
    scene(check, "scene-2", scene_2, new(point([0.0, 0.0, -3.0]), 0.5));
    #[cfg(not(handout))]
    search(check, "sphere", &|x| {
        new(Point3::new(x[0], x[1], x[2]), x[3])
    });
}

/// The textbook's `a t² + 2 b t + k = 0`, with a choice among its roots.
fn textbook(c: &mut Check, choose: fn([f64; 2], Interval) -> Option<f64>) {
    check(c, &move |c, r| {
        own(move |ray: &Ray, within| {
            let (f, d) = (ray.origin() - c, ray.direction());
            let (a, b) = (d.dot(d), f.dot(d));
            let root = (b * b - a * (f.dot(f) - r * r)).sqrt();
            let t = choose([(-b - root) / a, (-b + root) / a], within)?;
            Some(Hit::new(t, ((ray.at(t) - c) * (1.0 / r)).as_normal()))
        })
    });
}

fn first(roots: [f64; 2], within: Interval) -> Option<f64> {
    roots.into_iter().find(|t| within.contains(*t))
}

variants! { textbook:
    yours => &|c, r| shape::boxed(Sphere::new(c, r));
    right "the textbook's discriminant" => first;
    wrong "from inside, only the far root is ahead" => |[near, _], i| {
        Some(near).filter(|t| i.contains(*t))
    };
    wrong "a ray that touches hits: no root is below 0" => |roots, i| {
        first(roots, i).filter(|_| roots[0] < roots[1])
    };
}
