//! Whether a ray may meet the content of a sphere.

use crate::prelude::*;

/// Whether the ray, from its origin on, comes to within `r` of `c`.
///
/// `ray.at(t)` is a point of the ray, `ray.t_of(point)` the t of its nearest point to another one, and
/// `vector.magnitude()` a length.
pub fn may_meet(c: Point3, r: f64, ray: &Ray) -> bool {
    missing!("whether the ray comes near enough", true, {
        // Points behind the origin are no part of the ray.
        let nearest = ray.at(ray.t_of(c).max(0.0));
        (nearest - c).magnitude() <= r
    })
}

testing::examples! {
    let meets = |x, y| {
        let ray = Ray::derived(Point3::new(x, y, 0.0), Vector3::new(0.0, 2.0, 0.0));
        may_meet(Point3::ORIGIN, 2.0, &ray)
    };
    assert!(!meets(3.0, -5.0), "beside it");
    assert!(meets(2.0, -5.0), "just touching it");
    assert!(!meets(0.0, 3.0), "away from it");
    assert!(meets(0.0, 1.0), "from inside");
}
