//! Boxes with holes, with walls that stick out, or whose back hides the front.

use a02_math::{Normal3, Point3};
use a04_intersections::{Geometry, Hit, Interval, Plane};
use testing::exercise::{Check, Wrong};

use crate::own::Own;
use crate::six_planes::check;
use crate::solutions::six_planes::SixPlanes;

/// A candidate on one of the planes.
struct Found {
    axis: usize,
    point: [f64; 3],
    lbf: [f64; 3],
    run: [f64; 3],
}

impl Found {
    /// Whether it is between both corners along this axis, or beside by less.
    fn is_between(&self, axis: usize, beside: f64) -> bool {
        let Self {
            point, lbf, run, ..
        } = self;
        lbf[axis] - beside <= point[axis] && point[axis] <= run[axis] + beside
    }

    fn is_on_face(&self) -> bool {
        (0..3).all(|axis| axis == self.axis || self.is_between(axis, 0.0))
    }
}

/// A box of six planes, given which hits are on a face, and which of two to take.
fn planes(
    c: &mut Check,
    is_on_face: fn(&Found) -> bool,
    replaces: fn(new: &Hit, old: &Hit) -> bool,
) {
    check(c, |lbf: Point3, run: Point3| {
        SixPlanes::new(lbf, run)?;
        let mut planes = Vec::new();
        for axis in 0..3 {
            for (corner, outwards) in [(lbf, -1.0), (run, 1.0)] {
                let mut normal = [0.0; 3];
                normal[axis] = outwards;
                planes.push((axis, Plane::new(corner, Normal3::from_glam(normal.into()))?));
            }
        }
        let [lbf, run] = [lbf, run].map(|corner| corner.to_glam().to_array());
        Ok(Own(move |ray: &_, within| {
            let hits = planes.iter().filter_map(|(axis, plane)| {
                let hit = plane.hit(ray, within)?;
                let point = ray.at(hit.t).to_glam().to_array();
                is_on_face(&Found {
                    axis: *axis,
                    point,
                    lbf,
                    run,
                })
                .then_some(hit)
            });
            hits.reduce(|old, new| if replaces(&new, &old) { new } else { old })
        }))
    });
}

/// The right box, but for this.
fn changed(c: &mut Check, hit: fn(&SixPlanes, &a03_rays_cameras::Ray, Interval) -> Option<Hit>) {
    check(c, |lbf, run| {
        let shape = SixPlanes::new(lbf, run)?;
        Ok(Own(move |ray: &_, within| hit(&shape, ray, within)))
    });
}

fn is_nearer(new: &Hit, old: &Hit) -> bool {
    new.t < old.t
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "all three coordinates compared, which rounding spoils",
        says: "to [0.4, 1.2, 0.6]: expected 1, got",
        check: |c| planes(c, |f| (0..3).all(|axis| f.is_between(axis, 0.0)), is_nearer),
    },
    Wrong {
        mistake: "the last plane instead of the nearest",
        says: "to [0.4, 1.2, 0.6]: expected 1, got",
        check: |c| planes(c, Found::is_on_face, |_, _| true),
    },
    Wrong {
        mistake: "the first plane instead of the nearest",
        says: "to [0.4, 1.2, 0.6]: expected 1, got",
        check: |c| planes(c, Found::is_on_face, |_, _| false),
    },
    Wrong {
        mistake: "the farthest hit",
        says: "to [0.4, 1.2, 0.6]: expected 1, got",
        check: |c| planes(c, Found::is_on_face, |new, old| new.t > old.t),
    },
    Wrong {
        mistake: "a tolerance that makes the box larger",
        says: "t, just beside it, from [-1.300, 0.100, -0.310] along [1.000, 0.000, 0.000], box from [-0.3, 0.1, -0.7] to [0.4, 1.2, 0.6]: expected none, got 1",
        check: |c| {
            planes(
                c,
                |f| (0..3).all(|axis| f.is_between(axis, 1e-3)),
                is_nearer,
            );
        },
    },
    Wrong {
        mistake: "< instead of <= at the edges",
        says: "t, just on its edge, from",
        check: |c| {
            planes(
                c,
                |f| {
                    f.is_on_face()
                        && (0..3).all(|axis| axis == f.axis || f.point[axis] < f.run[axis])
                },
                is_nearer,
            );
        },
    },
    Wrong {
        mistake: "only one of the other axes compared",
        says: "to [0.4, 1.2, 0.6]: expected 1, got",
        check: |c| planes(c, |f| f.is_between((f.axis + 1) % 3, 0.0), is_nearer),
    },
    Wrong {
        mistake: "the interval left out",
        says: "t, the near face not in the interval, from",
        check: |c| {
            changed(c, |shape, ray, _| shape.hit(ray, Interval::AHEAD));
        },
    },
    Wrong {
        mistake: "only the nearest hit compared with the interval",
        says: "t, the near face not in the interval, from",
        check: |c| {
            changed(c, |shape, ray, within| {
                let hit = shape.hit(ray, Interval::AHEAD)?;
                within.contains(hit.t).then_some(hit)
            });
        },
    },
    Wrong {
        mistake: "a normal turned to the eye",
        says: "the normal, from inside, from",
        check: |c| {
            changed(c, |shape, ray, within| {
                use a02_math::Direction;
                let hit = shape.hit(ray, within)?;
                let leaves = hit.normal.dot(ray.direction()) > 0.0;
                Some(if leaves {
                    Hit::new(hit.t, -hit.normal)
                } else {
                    hit
                })
            });
        },
    },
];
