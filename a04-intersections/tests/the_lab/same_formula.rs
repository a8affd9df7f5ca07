//! The formula of the sphere that the experiments measure is that of the renderer.

use a02_math::Point3;
use a04_intersections::Sphere;
use a04_intersections::lab::experiments::sphere_distance::{FROM_AFAR, Shot, shots, stable};
use a04_intersections::lab::support::{first, raw_ray};

#[test]
fn the_stable_formula_is_that_of_the_renderer() {
    let sphere = Sphere::new(Point3::ORIGIN, 1.0).unwrap();
    let mut hits = 0;
    for Shot { c, r, o, d } in &*shots::<f64>(FROM_AFAR, 64.0, 1000) {
        let ours = first(&sphere, &raw_ray((*o, *d)));
        assert_eq!(stable(c, *r, o, d), ours);
        hits += u32::from(ours.is_some());
    }
    assert!((600..800).contains(&hits), "{hits}");
}
