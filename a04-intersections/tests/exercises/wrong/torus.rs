//! Tori of one size, marches that step too far, and one without an interval.

use a02_math::{Direction, Normal3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use testing::exercise::{Check, Wrong};

use crate::own::Own;
use crate::solutions::torus::Torus;
use crate::torus::check;

/// The right torus, but for its hits, given ring and tube.
fn hits(c: &mut Check, hit: fn(&Torus, [f64; 2], &Ray, Interval) -> Option<Hit>) {
    check(c, |ring, r| {
        let torus = Torus::new(ring, r)?;
        Ok(Own(move |ray: &_, within| {
            hit(&torus, [ring, r], ray, within)
        }))
    });
}

fn distance([ring, r]: [f64; 2], ray: &Ray, t: f64) -> f64 {
    let p = ray.at(t);
    libm::hypot(libm::hypot(p.x(), p.z()) - ring, p.y()) - r
}

/// The normal at `t`.
fn hit_at([ring, r]: [f64; 2], ray: &Ray, t: f64) -> Hit {
    let p = ray.at(t);
    let share = 1.0 - ring / libm::hypot(p.x(), p.z());
    Hit::new(
        t,
        Normal3::new(p.x() * share / r, p.y() / r, p.z() * share / r),
    )
}

/// The march by steps that are made of the distance, until that is small.
fn march(size: [f64; 2], ray: &Ray, within: Interval, step: impl Fn(f64) -> f64) -> Option<Hit> {
    let mut t = within.min.max(0.0);
    for _ in 0..10_000 {
        let distance = distance(size, ray, t);
        if distance < 1e-12 {
            return within.contains(t).then(|| hit_at(size, ray, t));
        }
        t += step(distance);
    }
    None
}

/// The direction's length.
fn length(ray: &Ray) -> f64 {
    ray.direction().dot(ray.direction()).sqrt()
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the ring 2 and the tube 1/2",
        says: "t, along the normal, from [1.950, 0.000, 0.000] to [1.750, 0.000, 0.000], ring 1, tube 0.75: expected 1, got 2.25",
        check: |c| check(c, |_, _| Torus::new(2.0, 0.5)),
    },
    Wrong {
        mistake: "a march that begins outside",
        says: "t, from within the tube, from [2.200, 0.000, 0.000] to [2.500, 0.000, 0.000], ring 2, tube 0.5: expected 1, got none",
        check: |c| {
            hits(c, |_, size, ray, within| {
                march(size, ray, within, |d| d / length(ray))
            });
        },
    },
    Wrong {
        mistake: "steps not divided by the direction's length",
        says: "t, from the side, near the top, direction of length 4, ring 2, tube 0.5: expected 0.722",
        check: |c| {
            hits(c, |torus, size, ray, within| {
                let starts_inside = distance(size, ray, within.min) < 1e-9;
                if starts_inside {
                    torus.hit(ray, within)
                } else {
                    march(size, ray, within, |d| d)
                }
            });
        },
    },
    Wrong {
        mistake: "steps of one length, between which the crossing is lost",
        says: "ring 2, tube 0.5: expected 1, got 1.0010",
        check: |c| {
            hits(c, |torus, size, ray, within| {
                let starts_inside = distance(size, ray, within.min) < 1e-9;
                if starts_inside {
                    torus.hit(ray, within)
                } else {
                    march(size, ray, within, |_| 0.013)
                }
            });
        },
    },
    Wrong {
        mistake: "a normal from the origin, as of a sphere",
        says: "ring 2, tube 0.5: expected (0, 1, 0), got (0.97",
        check: |c| {
            hits(c, |torus, _, ray, within| {
                let hit = torus.hit(ray, within)?;
                let p = ray.at(hit.t).to_glam();
                let n = Vector3::new(p.x, p.y, p.z).normalized()?.as_normal();
                Some(Hit::new(hit.t, n))
            });
        },
    },
    Wrong {
        mistake: "the start of the interval left out",
        says: "t, straight through, after t = 1.255, ring 2, tube 0.5: expected 1.75, got 1.25",
        check: |c| {
            hits(c, |torus, _, ray, within| {
                torus.hit(ray, Interval { min: 0.0, ..within })
            });
        },
    },
    Wrong {
        mistake: "the end of the interval left out",
        says: "t, straight through, before t = 1.245, ring 2, tube 0.5: expected none, got 1.25",
        check: |c| {
            hits(c, |torus, _, ray, within| {
                torus.hit(
                    ray,
                    Interval {
                        max: f64::INFINITY,
                        ..within
                    },
                )
            });
        },
    },
    Wrong {
        mistake: "a ball of ring and tube, without a hole",
        says: "t, along the normal, from [2.000, 0.900, 0.000] to [2.000, 0.500, 0.000], ring 2, tube 0.5: expected 1, got 6",
        check: |c| {
            check(c, |ring, r| {
                a04_intersections::Sphere::new(a02_math::Point3::ORIGIN, ring + r)
            });
        },
    },
];
