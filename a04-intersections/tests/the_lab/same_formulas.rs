//! The formulas that the experiments measure are those of the renderer.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::experiments::needle::{needles, plain};
use a04_intersections::lab::experiments::sphere_distance::{stable, view_from};
use a04_intersections::lab::extremes::first;
use a04_intersections::{Sphere, Triangle};

#[test]
fn the_stable_formula_of_the_sphere_is_that_of_the_renderer() {
    let sphere = Sphere::new(Point3::ORIGIN, 1.0).unwrap();
    let view = view_from::<f64>(64.0, 1000);
    let mut hits = 0;
    for [o, d] in &view.rays {
        let [origin, direction] = [o, d].map(|v| Vector3::from_glam((*v).into()));
        let ours = first(&sphere, &Ray::derived(Point3::ORIGIN + origin, direction));
        assert_eq!(stable(&view.c, view.r, o, d), ours);
        hits += u32::from(ours.is_some());
    }
    assert!((600..800).contains(&hits), "{hits}");
}

#[test]
fn the_plain_test_of_triangles_is_that_of_the_renderer() {
    let mut hits = 0;
    for needle in needles(1.0, 512) {
        let [a, b, c] = needle.corners;
        let triangle = Triangle::new(a, b, c).unwrap();
        for ray in &needle.rays {
            let ours = first(&triangle, ray);
            assert_eq!(plain(&needle.corners, ray), ours);
            hits += u32::from(ours.is_some());
        }
    }
    assert!((150..350).contains(&hits), "{hits}");
}
