//! `secondary_ray`: a ray that leaves a surface without hitting it again.

use crate::prelude::*;

/// The ray that leaves the hit of `ray` in a direction of length 1, to either side of the
/// surface. Its origin is `ray.at(hit.t)`, offset along the normal `hit.geometric_normal` of length 1 by
/// more than its rounding error, and by far less than one could see.
///
/// `point.largest_coordinate()` is the greatest magnitude of its coordinates, and `hit.scale` that of the numbers
/// of the shape. `n.dot(v)` is a dot product, and `Vector3::from(n)` the normal as a vector.
pub fn secondary_ray(ray: &Ray, hit: &Hit, direction: Vector3) -> Ray {
    let on_surface = Ray::derived(ray.at(hit.t), direction);
    // 1. Bound the rounding error of the hit by the largest number in its computation.
    // 2. Choose the side of the surface to which the direction leads.
    // 3. Move the origin along the normal, to this side, by more than the error.
    missing!("the origin of the ray", on_surface, {
        let point = ray.at(hit.t);
        let of_points = ray
            .origin()
            .largest_coordinate()
            .max(point.largest_coordinate());
        let largest = of_points.max(hit.t).max(hit.scale);
        let error = 64.0 * f64::EPSILON * largest;
        let leads_below = hit.geometric_normal.dot(direction) < 0.0;
        let offset = if leads_below { -error } else { error };
        let origin = point + Vector3::from(hit.geometric_normal) * offset;
        Ray::derived(origin, direction)
    })
}

testing::examples! {
    let ray = Ray::derived(Point3::new(0.0, 2.0, 0.0), Vector3::new(0.0, -1.0, 0.0));
    let hit = Hit::new(2.0, Normal3::new(0.0, 1.0, 0.0));
    let leave = |y| secondary_ray(&ray, &hit, Vector3::new(0.6, y, 0.0));
    assert_close!(array(leave(0.8).direction()), [0.6, 0.8, 0.0]);
    assert!(leave(0.8).origin().y() > 0.0, "outwards, it begins above the surface");
    assert!(leave(-0.8).origin().y() < 0.0, "inwards, it begins below");
    assert!(leave(0.8).origin().y() < 1e-9, "but not far away");
}
