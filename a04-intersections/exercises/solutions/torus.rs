//! `Torus`: a ring around the y axis.

use crate::prelude::*;

/// All points at the distance `r` from a circle of the radius `ring`, which lies
/// around the origin in the plane y = 0.
#[derive(Clone, Copy, Debug)]
pub struct Torus {
    ring: f64,
    r: f64,
}

impl Torus {
    /// The torus of a circle of the radius `ring`, with a tube of the smaller radius `r`.
    pub fn new(ring: f64, r: f64) -> Result<Self, ArgumentError> {
        let ring = argument::length("radius of the ring", ring)?;
        let r = argument::length("radius r", r)?;
        argument::check("radius r", r, r < ring, "less than that of the ring")?;
        Ok(Self { ring, r })
    }

    /// How far `p` is from the surface: negative in the tube.
    fn distance(&self, p: Point3) -> f64 {
        missing!("the distance from the surface", f64::INFINITY, {
            let from_axis = libm::hypot(p.x(), p.z());
            libm::hypot(from_axis - self.ring, p.y()) - self.r
        })
    }
}

impl Geometry for Torus {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        // Nothing is met as far from the origin as this.
        let length = ray.direction().magnitude();
        let reach = (self.ring + 2.0 * self.r) / length;
        let middle = ray.t_of(Point3::ORIGIN);
        let (start, end) = (within.min.max(middle - reach), middle + reach);
        let distance = |t: f64| self.distance(ray.at(t));

        let t = missing!("the first t at which the distance is 0", f64::NAN, {
            // As far as the surface is away, nothing is in the way. Steps that are
            // never smaller than this walk away from it, and through it.
            let smallest = 1e-4 * self.r / length;
            let (mut t, mut step) = (start + smallest, 0.0);
            let starts_inside = distance(t) < 0.0;
            while (distance(t) < 0.0) == starts_inside {
                if t > end {
                    return None;
                }
                step = (distance(t).abs() / length).max(smallest);
                t = (t + step).max(t.next_up());
            }
            // The surface lies in the last step: halve it, and stay behind the surface.
            for _ in 0..60 {
                step /= 2.0;
                if (distance(t - step) < 0.0) != starts_inside {
                    t -= step;
                }
            }
            t
        });

        // The normal leads to the hit from the nearest point of the circle.
        let p = ray.at(t);
        let around = Vector3::new(p.x(), 0.0, p.z()).normalized()?;
        let normal = (p - (Point3::ORIGIN + around * self.ring)).normalized()?;
        within.contains(t).then(|| Hit::new(t, normal.as_normal()))
    }
}

testing::examples! {
    let torus = Torus::new(2.0, 0.5).unwrap();
    let hit = |x, y, dy| {
        hit_from([x, y, 0.0], [0.0, dy, 0.0], &torus).map(|hit| [hit.t, hit.normal.y()])
    };
    assert_close!(hit(2.0, 5.0, -1.0), Some([4.5, 1.0]));
    assert_close!(hit(2.0, 5.0, -2.0), Some([2.25, 1.0]));
    assert_close!(hit(2.0, 0.0, -1.0), Some([0.5, -1.0]));
    assert!(hit(0.0, 5.0, -1.0).is_none(), "no hit through the hole");
}
