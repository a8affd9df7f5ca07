//! Triangles anywhere, compared with the lesson's.

use crate::prelude::*;

pub fn check(check: &mut Check, new: &dyn Fn(Point3, Point3, Point3) -> Made<Shape>) {
    compare(
        check,
        "triangle {}",
        [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [0.0, 2.0, 1.0]],
        |r| [(); 3].map(|()| r.triple(5.0)),
        &|[a, b, c]| boxed(Triangle::new(point(a), point(b), point(c))),
        &|[a, b, c]| new(point(a), point(b), point(c)),
    );
    let [a, b, c] = [[-0.5, 0.5, -3.0], [0.5, 0.5, -3.0], [0.5, -0.5, -3.0]].map(point);
    scene(check, "scene-4", scene_4, new(a, b, c));
    #[cfg(not(handout))]
    search(check, "triangle", &|x| {
        let [a, b, c] = [0, 3, 6].map(|i| Point3::new(x[i], x[i + 1], x[i + 2]));
        new(a, b, c)
    });
}

/// The test of Möller and Trumbore, which accepts two coordinates.
fn moeller_trumbore(c: &mut Check, is_inside: fn(f64, f64) -> bool) {
    check(c, &move |a, b, c| {
        let (ab, ac) = (b - a, c - a);
        own(move |ray: &Ray, within| {
            let (d, ao) = (ray.direction(), ray.origin() - a);
            let (p, q) = (d.cross(ac), ao.cross(ab));
            let determinant = ab.dot(p);
            let (beta, gamma) = (ao.dot(p) / determinant, d.dot(q) / determinant);
            let t = ac.dot(q) / determinant;
            let normal = ab.cross(ac).normalized()?.as_normal();
            (is_inside(beta, gamma) && within.contains(t)).then(|| Hit::new(t, normal))
        })
    });
}

variants! { moeller_trumbore:
    yours => &|a, b, c| shape::boxed(Triangle::new(a, b, c));
    right "Möller and Trumbore" => |b, g| b >= 0.0 && g >= 0.0 && b + g <= 1.0;
    wrong "edges belong to the triangle" => |b, g| b > 0.0 && g > 0.0 && b + g < 1.0;
}
