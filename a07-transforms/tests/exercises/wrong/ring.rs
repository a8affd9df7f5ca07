//! Rings without a hole, around another point, or without their border.

use a02_math::{Direction, Point3};
use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval, Plane};
use testing::exercise::{Check, Wrong};

use crate::own::Own;
use crate::ring::check;
use crate::solutions::ring::Ring;

/// A part of the plane, given the squared distance from the centre, the hole's radius
/// and the ring's.
fn part(c: &mut Check, is_on_ring: fn(f64, f64, f64) -> bool) {
    check(c, |centre, n, hole, r| {
        let plane = Plane::new(centre, n)?;
        Ok(Own(move |ray: &Ray, within| {
            let hit = plane.hit(ray, within)?;
            let way = ray.at(hit.t) - centre;
            is_on_ring(way.dot(way), hole, r).then_some(hit)
        }))
    });
}

/// The right ring, but for its hits.
fn hits(c: &mut Check, hit: fn(&Ring, &Ray, Interval) -> Option<Hit>) {
    check(c, |centre, n, hole, r| {
        let ring = Ring::new(centre, n, hole, r)?;
        Ok(Own(move |ray: &_, within| hit(&ring, ray, within)))
    });
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "< at both borders, which belong to the ring",
        says: "t at the distance 5, over (3, 4), ring from 5 to 13 around [1, 2, 3], both included: expected 2, got none",
        check: |c| {
            part(c, |squared, hole, r| {
                hole < squared.sqrt() && squared.sqrt() < r
            });
        },
    },
    Wrong {
        mistake: "the outer border not included",
        says: "t at the distance 13, over (5, -12), ring from 5 to 13 around [1, 2, 3], both included: expected 2, got none",
        check: |c| {
            part(c, |squared, hole, r| {
                (hole * hole..r * r).contains(&squared)
            });
        },
    },
    Wrong {
        mistake: "the hole's border not included",
        says: "t at the distance 5, over (3, 4), ring from 5 to 13 around [1, 2, 3], both included: expected 2, got none",
        check: |c| {
            part(c, |squared, hole, r| {
                hole * hole < squared && squared <= r * r
            });
        },
    },
    Wrong {
        mistake: "no hole",
        says: ", ring from 0.5 to 2 around [3, -1, 2]: expected none, got 1",
        check: |c| part(c, |squared, _, r| squared <= r * r),
    },
    Wrong {
        mistake: "no outer rim",
        says: ", ring from 0.5 to 2 around [3, -1, 2]: expected none, got",
        check: |c| part(c, |squared, hole, _| squared >= hole * hole),
    },
    Wrong {
        mistake: "a squared distance between radii that are not squared",
        says: "t at the distance 5, over (3, 4), ring from 5 to 13 around [1, 2, 3], both included: expected 2, got none",
        check: |c| part(c, |squared, hole, r| (hole..=r).contains(&squared)),
    },
    Wrong {
        mistake: "around the origin",
        says: ", ring from 0.5 to 2 around [3, -1, 2]: expected 1, got none",
        check: |c| {
            check(c, |centre, n, hole, r| {
                let plane = Plane::new(centre, n)?;
                Ok(Own(move |ray: &Ray, within| {
                    let hit = plane.hit(ray, within)?;
                    let way = ray.at(hit.t) - Point3::ORIGIN;
                    (hole * hole..=r * r).contains(&way.dot(way)).then_some(hit)
                }))
            });
        },
    },
    Wrong {
        mistake: "the interval left out",
        says: "t, the interval ends before it, ring from 0.5 to 2 around [3, -1, 2]: expected none, got 2",
        check: |c| hits(c, |ring, ray, _| ring.hit(ray, Interval::AHEAD)),
    },
    Wrong {
        mistake: "what is behind the eye, too",
        says: "t, away from it, ring from 0.5 to 2 around [3, -1, 2]: expected none, got -2",
        check: |c| {
            hits(c, |ring, ray, within| {
                ring.hit(
                    ray,
                    Interval {
                        min: f64::NEG_INFINITY,
                        max: within.max,
                    },
                )
            });
        },
    },
];
