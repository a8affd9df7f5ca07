//! The sphere test that the experiment measures.

use a02_math::{Point3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::lab::experiments::sphere_distance::{stable, view_from};
use a04_intersections::{Geometry, Interval, Sphere};

#[test]
fn the_stable_formula_is_that_of_the_renderer() {
    let sphere = Sphere::new(Point3::ORIGIN, 1.0).unwrap();
    let view = view_from::<f64>(64.0, 1000);
    let mut hits = 0;
    for [o, d] in &view.rays {
        let [origin, direction] = [o, d].map(|v| Vector3::from_glam((*v).into()));
        let ray = Ray::derived(Point3::ORIGIN + origin, direction);
        let ours = sphere.hit(&ray, Interval::AHEAD).map(|hit| hit.t);
        assert_eq!(stable(&view.c, view.r, o, d), ours);
        hits += u32::from(ours.is_some());
    }
    assert!((600..800).contains(&hits), "{hits}");
}
