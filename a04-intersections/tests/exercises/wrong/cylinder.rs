//! Tubes of one size, without a far wall, or without ends.

use a02_math::{Direction, Normal3, Vector3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use testing::exercise::{Check, Wrong};

use crate::cylinder::check;
use crate::own::Own;
use crate::solutions::cylinder::Cylinder;

/// The right tube, but for its hits.
fn hits(c: &mut Check, hit: fn(&Cylinder, [f64; 2], &Ray, Interval) -> Option<Hit>) {
    check(c, |r, height| {
        let tube = Cylinder::new(r, height)?;
        Ok(Own(move |ray: &_, within| {
            hit(&tube, [r, height], ray, within)
        }))
    });
}

/// The right tube with another normal, made of the radius, the point of the hit and
/// the right normal.
fn normals(c: &mut Check, normal: fn(f64, Vector3, Normal3, &Ray) -> Normal3) {
    check(c, |r, height| {
        let tube = Cylinder::new(r, height)?;
        Ok(Own(move |ray: &Ray, within| {
            let hit = tube.hit(ray, within)?;
            let p = ray.at(hit.t).to_glam();
            let p = Vector3::new(p.x, p.y, p.z);
            Some(Hit::new(hit.t, normal(r, p, hit.normal, ray)))
        }))
    });
}

/// The crossings of the endless tube.
fn crossings(r: f64, ray: &Ray, a: Option<f64>) -> Option<[f64; 2]> {
    let (o, d) = (ray.origin(), ray.direction());
    let a = a.unwrap_or(d.x() * d.x() + d.z() * d.z());
    let b = o.x() * d.x() + o.z() * d.z();
    let root = (b * b - a * (o.x() * o.x() + o.z() * o.z() - r * r)).sqrt();
    (root >= 0.0).then_some([(-b - root) / a, (-b + root) / a])
}

fn hit_at(t: f64, r: f64, ray: &Ray) -> Hit {
    let p = ray.at(t);
    Hit::new(t, Normal3::new(p.x() / r, 0.0, p.z() / r))
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "a normal that is not divided by the radius",
        says: "radius 3, height 0.5: expected (1, 0, 0), got (3, 0, 0)",
        check: |c| normals(c, |_, p, _, _| Normal3::new(p.x(), 0.0, p.z())),
    },
    Wrong {
        mistake: "the radius 1",
        says: "t, at the near wall, from [12.000, 0.250, 1.500] to [3.000, 0.125, 0.000], radius 3, height 0.5: expected 1, got 1.22",
        check: |c| check(c, |_, height| Cylinder::new(1.0, height)),
    },
    Wrong {
        mistake: "the height 2",
        says: "t, over the rim, from [9.000, 1.500, 0.000] to [-3.000, 0.125, 0.000], radius 3, height 0.5: expected 1, got 0.5",
        check: |c| check(c, |r, _| Cylinder::new(r, 2.0)),
    },
    Wrong {
        mistake: "only the smaller root",
        says: "t, from inside, from [0.200, 1.000, 0.100] to [1.000, 0.500, 0.000], radius 1, height 2: expected 1, got none",
        check: |c| {
            hits(c, |_, [r, height], ray, within| {
                let t = crossings(r, ray, None)?[0];
                let is_on_wall = (0.0..=height).contains(&ray.at(t).y());
                (is_on_wall && within.contains(t)).then(|| hit_at(t, r, ray))
            });
        },
    },
    Wrong {
        mistake: "the height compared at the nearer crossing alone",
        says: "t, over the rim, from [3.000, 6.000, 0.000] to [-1.000, 0.500, 0.000], radius 1, height 2: expected 1, got none",
        check: |c| {
            hits(c, |_, [r, height], ray, within| {
                let t = crossings(r, ray, None)?
                    .into_iter()
                    .find(|&t| within.contains(t))?;
                let is_on_wall = (0.0..=height).contains(&ray.at(t).y());
                is_on_wall.then(|| hit_at(t, r, ray))
            });
        },
    },
    Wrong {
        mistake: "no ends",
        says: "t, over the rim, from [3.000, 6.000, 0.000] to [-1.000, 0.500, 0.000], radius 1, height 2: expected 1, got 0.5",
        check: |c| {
            hits(c, |_, [r, _], ray, within| {
                let t = crossings(r, ray, None)?
                    .into_iter()
                    .find(|&t| within.contains(t))?;
                Some(hit_at(t, r, ray))
            });
        },
    },
    Wrong {
        mistake: "a direction taken for one of length 1",
        says: "t, at the near wall, from [4.000, 1.000, 0.500] to [1.000, 0.500, 0.000], radius 1, height 2: expected 1, got",
        check: |c| {
            hits(c, |_, [r, height], ray, within| {
                let is_on_wall = |t: &f64| (0.0..=height).contains(&ray.at(*t).y());
                let mut ts = crossings(r, ray, Some(1.0))?.into_iter();
                let t = ts.find(|t| within.contains(*t) && is_on_wall(t))?;
                Some(hit_at(t, r, ray))
            });
        },
    },
    Wrong {
        mistake: "the interval left out",
        says: "t, from inside, from [0.200, 1.000, 0.100] to [1.000, 0.500, 0.000], radius 1, height 2: expected 1, got -1.46",
        check: |c| {
            hits(c, |tube, _, ray, _| {
                tube.hit(
                    ray,
                    Interval {
                        min: f64::NEG_INFINITY,
                        max: f64::INFINITY,
                    },
                )
            });
        },
    },
    Wrong {
        mistake: "< instead of <= at the ends",
        says: "t, at the rim, which belongs to it, radius 1, height 2: expected 4, got none",
        check: |c| {
            hits(c, |tube, [_, height], ray, within| {
                let hit = tube.hit(ray, within)?;
                let y = ray.at(hit.t).y();
                (0.0 < y && y < height).then_some(hit)
            });
        },
    },
    Wrong {
        mistake: "rays that touch taken for rays that miss",
        says: "t, touching the wall, radius 1, height 2: expected 5, got none",
        check: |c| {
            hits(c, |tube, [r, _], ray, within| {
                let [near, far] = crossings(r, ray, None)?;
                if near == far {
                    None
                } else {
                    tube.hit(ray, within)
                }
            });
        },
    },
    Wrong {
        mistake: "half of the height above the origin, half below",
        says: "to [1.000, 1.500, 0.000], radius 1, height 2: expected 1, got none",
        check: |c| {
            hits(c, |_, [r, height], ray, within| {
                let is_on_wall = |t: &f64| ray.at(*t).y().abs() <= height / 2.0;
                let mut ts = crossings(r, ray, None)?.into_iter();
                let t = ts.find(|t| within.contains(*t) && is_on_wall(t))?;
                Some(hit_at(t, r, ray))
            });
        },
    },
    Wrong {
        mistake: "a normal from the origin, as of a sphere",
        says: "the normal, at the near wall, from [4.000, 1.000, 0.500] to [1.000, 0.500, 0.000], radius 1, height 2: expected (1, 0, 0), got (0.89",
        check: |c| normals(c, |_, p, n, _| p.normalized().map_or(n, Vector3::as_normal)),
    },
    Wrong {
        mistake: "a normal turned to the eye",
        says: "the normal, from inside, from [0.200, 1.000, 0.100] to [1.000, 0.500, 0.000], radius 1, height 2: expected (1, 0, 0), got (-0.99",
        check: |c| {
            normals(
                c,
                |_, _, n, ray| if n.dot(ray.direction()) > 0.0 { -n } else { n },
            );
        },
    },
];
