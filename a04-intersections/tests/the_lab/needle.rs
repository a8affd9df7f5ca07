//! The triangle test that the experiment measures.

use a04_intersections::lab::experiments::needle::{needles, plain};
use a04_intersections::{Geometry, Interval, Triangle};

#[test]
fn the_plain_test_is_that_of_the_renderer() {
    let mut hits = 0;
    for needle in needles(1.0, 512) {
        let [a, b, c] = needle.corners;
        let triangle = Triangle::new(a, b, c).unwrap();
        for ray in &needle.rays {
            let ours = triangle.hit(ray, Interval::AHEAD).map(|hit| hit.t);
            assert_eq!(plain(&needle.corners, ray), ours);
            hits += u32::from(ours.is_some());
        }
    }
    assert!((150..350).contains(&hits), "{hits}");
}
