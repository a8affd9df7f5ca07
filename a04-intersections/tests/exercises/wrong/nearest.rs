//! Wrong solutions.

use a02_math::Direction;
use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval, World};
use testing::exercise::Wrong;

use crate::nearest;

/// All hits, each the nearest of its object.
fn hits(world: &World<usize>, ray: &Ray, within: Interval) -> Vec<(Hit, usize)> {
    let objects = world.objects();
    let hits = objects.filter_map(|(geometry, number)| Some((geometry.hit(ray, within)?, *number)));
    hits.map(|(hit, number)| (facing(hit, ray), number))
        .collect()
}

fn facing(hit: Hit, ray: &Ray) -> Hit {
    if hit.face.dot(ray.direction()) < 0.0 {
        return hit;
    }
    Hit {
        normal: -hit.normal,
        face: -hit.face,
        ..hit
    }
}

fn first(hits: Vec<(Hit, usize)>) -> Option<(Hit, usize)> {
    hits.into_iter().min_by(|a, b| a.0.t.total_cmp(&b.0.t))
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "the first object of the list that is hit",
        says: "t of the nearest sphere",
        check: |c| {
            nearest::check(c, |world, ray, within| {
                hits(world, ray, within).first().copied()
            });
        },
    },
    Wrong {
        mistake: "the last hit that was found",
        says: "t of the nearest sphere",
        check: |c| {
            nearest::check(c, |world, ray, within| {
                hits(world, ray, within).last().copied()
            });
        },
    },
    Wrong {
        mistake: "the interval checked after the search, not in it",
        says: "as the interval begins at 4.5",
        check: |c| {
            nearest::check(c, |world, ray, within| {
                first(hits(world, ray, Interval::AHEAD)).filter(|(hit, _)| within.contains(hit.t))
            });
        },
    },
    Wrong {
        mistake: "the normals are not turned",
        says: "the normal against the ray, n · d, from inside",
        check: |c| {
            nearest::check(c, |world, ray, within| {
                let objects = world.objects();
                let hits =
                    objects.filter_map(|(shape, number)| Some((shape.hit(ray, within)?, *number)));
                first(hits.collect())
            });
        },
    },
    Wrong {
        mistake: "only the shading normal is turned",
        says: "the face against the ray, n · d, from inside",
        check: |c| {
            nearest::check(c, |world, ray, within| {
                let (hit, number) = first(hits(world, ray, within))?;
                let (shape, _) = world.objects().nth(number)?;
                Some((
                    Hit {
                        face: shape.hit(ray, within)?.face,
                        ..hit
                    },
                    number,
                ))
            });
        },
    },
];
