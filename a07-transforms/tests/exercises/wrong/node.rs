//! Wrong solutions.

use a03_rays_cameras::Ray;
use a04_intersections::{Geometry, Hit, Interval};
use a07_transforms::Transform;
use testing::exercise::{Check, Wrong};

use crate::node;

type Children = [Box<dyn Geometry>];

#[derive(Debug)]
struct Node(
    Transform,
    Vec<Box<dyn Geometry>>,
    fn(&Transform, &Children, &Ray, Interval) -> Option<Hit>,
);

impl Geometry for Node {
    fn hit(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        (self.2)(&self.0, &self.1, ray, within)
    }
}

fn check(check: &mut Check, hit: fn(&Transform, &Children, &Ray, Interval) -> Option<Hit>) {
    node::check(check, |transform, children| Node(transform, children, hit));
}

/// All hits of children in their own space.
fn hits(children: &Children, ray: &Ray, within: Interval) -> impl Iterator<Item = Hit> {
    children
        .iter()
        .filter_map(move |child| child.hit(ray, within))
}

fn nearest(hits: impl Iterator<Item = Hit>) -> Option<Hit> {
    hits.min_by(|a, b| a.t.total_cmp(&b.t))
}

fn around(t: &Transform, hit: Hit) -> Option<Hit> {
    let (normal, face) = (
        t.normal_from_object(hit.normal)?,
        t.normal_from_object(hit.face)?,
    );
    Some(Hit {
        normal,
        face,
        ..hit
    })
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the ray is not transformed",
        says: "a ball; chain",
        check: |c| {
            check(c, |t, all, ray, within| {
                around(t, nearest(hits(all, ray, within))?)
            });
        },
    },
    Wrong {
        mistake: "the normals stay in the space of the children",
        says: "the normal, a ball",
        check: |c| {
            check(c, |t, all, ray, within| {
                nearest(hits(all, &t.ray_to_object(ray), within))
            });
        },
    },
    Wrong {
        mistake: "the first child that is hit",
        says: "t, a small ball and a larger one around it",
        check: |c| {
            check(c, |t, all, ray, within| {
                around(t, hits(all, &t.ray_to_object(ray), within).next()?)
            });
        },
    },
    Wrong {
        mistake: "the last child that is hit",
        says: "t, a ball and a smaller one in it",
        check: |c| {
            check(c, |t, all, ray, within| {
                around(t, hits(all, &t.ray_to_object(ray), within).last()?)
            });
        },
    },
    Wrong {
        mistake: "the interval is left out",
        says: "t, a ball, but the interval ends before",
        check: |c| {
            check(c, |t, all, ray, _| {
                around(
                    t,
                    nearest(hits(all, &t.ray_to_object(ray), Interval::AHEAD))?,
                )
            });
        },
    },
    Wrong {
        mistake: "only the shading normal is transformed",
        says: "the face, a ball",
        check: |c| {
            check(c, |t, all, ray, within| {
                let hit = nearest(hits(all, &t.ray_to_object(ray), within))?;
                Some(Hit {
                    normal: t.normal_from_object(hit.normal)?,
                    ..hit
                })
            });
        },
    },
];
