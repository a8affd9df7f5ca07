//! `Sheared`: a shape that leans.

use crate::prelude::*;

/// A shape whose points have been pushed aside by their height: (x, y, z) has
/// become (x + `by` y, y, z).
#[derive(Clone, Copy, Debug)]
pub struct Sheared<G> {
    shape: G,
    by: f64,
}

impl<G> Sheared<G> {
    /// This shape, sheared.
    pub const fn new(shape: G, by: f64) -> Self {
        Self { shape, by }
    }
}

impl<G: Geometry> Geometry for Sheared<G> {
    /// The hit of the upright shape and the ray as that one sees it, which has the same `t`.
    ///
    /// `Point3::new(x, y, z)` makes a point, and `Vector3::new(x, y, z)` a vector; all have `x()`, `y()` and `z()`.
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        let (o, d) = (ray.origin(), ray.direction());
        let (o, d) = missing!("origin and direction, sheared back", (o, d), {
            // Points and vectors alike: a shear leaves the origin where it is.
            let o = Point3::new(o.x() - self.by * o.y(), o.y(), o.z());
            (o, Vector3::new(d.x() - self.by * d.y(), d.y(), d.z()))
        });
        let mut hit = self.shape.hit(&Ray::derived(o, d), within)?;
        for n in [&mut hit.normal, &mut hit.geometric_normal] {
            let leaning = missing!("the normal of the leaning shape", Vector3::from(*n), {
                // The transpose of the inverse matrix.
                Vector3::new(n.x(), n.y() - self.by * n.x(), n.z())
            });
            *n = leaning.normalized()?.as_normal();
        }
        Some(hit)
    }
}

testing::examples! {
    let wall = Plane::new(Point3::ORIGIN, Normal3::new(1.0, 0.0, 0.0)).unwrap();
    let leaning = Sheared::new(wall, 2.0);
    let hit = |y, dy| hit_from([5.0, y, 0.0], [-1.0, dy, 0.0], &leaning);
    assert_close!(hit(0.0, 0.0).map(|hit| hit.t), Some(5.0), "at height 0 nothing moves");
    assert_close!(hit(1.0, 0.0).map(|hit| hit.t), Some(3.0), "at height 1 it is nearer by 2");
    assert_close!(hit(0.0, 1.0).map(|hit| hit.t * 3.0), Some(5.0), "aslant");
    let n = hit(1.0, 0.0).unwrap().normal;
    assert_close!([2.0 * n.x(), -n.y()].map(|x| x * 5_f64.sqrt()), [2.0, 2.0]);
}
