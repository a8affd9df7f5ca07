//! A thin lens: objects in focus are sharp, and all others are not.

use crate::prelude::*;

/// The ray through the place (`right`, `up`) of the lens, in lengths from the eye along `u`
/// and `v` of the `basis`, instead of `ray`, which starts in the eye. Both meet in the plane
/// across the gaze at the distance `focus`. The direction has length 1.
///
/// `a.dot(b)` is a dot product; `vector.normalized()` is `None` for the zero vector.
pub fn through_lens(basis: &Basis, focus: f64, ray: &Ray, (right, up): (f64, f64)) -> Ray {
    missing!("the ray through the lens", *ray, {
        // Along the gaze the ray makes this much of its length.
        let along = -basis.w.dot(ray.direction());
        let sharp = ray.at(focus / along);
        let origin = basis.e + basis.u * right + basis.v * up;
        let direction = (sharp - origin).normalized();
        Ray::derived(origin, direction.unwrap_or(-basis.w))
    })
}

testing::examples! {
    let [gaze, up] = [Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0)];
    let basis = Basis::new(Point3::ORIGIN, gaze, up).unwrap();
    let ahead = Ray::derived(Point3::ORIGIN, gaze);
    let ray = through_lens(&basis, 4.0, &ahead, (0.0, 0.0));
    assert_close!(array(ray.direction()), array(ahead.direction()), "through the middle");
    let ray = through_lens(&basis, 4.0, &ahead, (3.0, 0.0));
    assert_close!(array(ray.origin()), [3.0, 0.0, 0.0]);
    assert_close!(array(ray.direction()), [-0.6, 0.0, -0.8]);
    let aslant = Ray::derived(Point3::ORIGIN, Vector3::new(0.6, 0.0, -0.8));
    let ray = through_lens(&basis, 4.0, &aslant, (3.0, 1.0));
    assert_close!(array(ray.at(17_f64.sqrt())), [3.0, 0.0, -4.0]);
}
