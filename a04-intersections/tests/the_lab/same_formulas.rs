//! The formulas that the experiments measure are those of the renderer.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::experiments::needle::{needles, plain};
use a04_intersections::lab::experiments::sphere_distance::{Shot, shots_from, stable};
use a04_intersections::lab::extremes::first;
use a04_intersections::{Sphere, Triangle};

#[test]
fn the_stable_formula_of_the_sphere_is_that_of_the_renderer() {
    let sphere = Sphere::new(Point3::ORIGIN, 1.0).unwrap();
    let mut hits = 0;
    for Shot { c, r, o, d } in &*shots_from::<f64>(64.0, 1000) {
        let [origin, direction] = [o, d].map(|v| Vector3::from_glam((*v).into()));
        let ours = first(&sphere, &Ray::derived(Point3::ORIGIN + origin, direction));
        assert_eq!(stable(c, *r, o, d), ours);
        hits += u32::from(ours.is_some());
    }
    assert!((600..800).contains(&hits), "{hits}");
}

#[test]
fn the_plain_test_of_triangles_is_that_of_the_renderer() {
    let mut hits = 0;
    for (corners @ [a, b, c], ray) in &*needles(1.0, 512) {
        let ours = first(&Triangle::new(*a, *b, *c).unwrap(), ray);
        assert_eq!(plain(corners, ray), ours);
        hits += u32::from(ours.is_some());
    }
    assert!((150..350).contains(&hits), "{hits}");
}
