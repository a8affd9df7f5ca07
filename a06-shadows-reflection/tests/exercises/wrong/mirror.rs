//! Wrong solutions: the recursion with one part changed.

use a02_math::Vector3;
use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval};
use a06_shadows_reflection::{RecursiveTracer, ShadowedWorld, secondary_ray};
use common::Color;
use testing::exercise::{Check, Wrong};

use crate::mirror;

/// The colour of a surface from its own, its reflectance and the colour of the reflected ray;
/// the direction of the reflected ray; and the colour of the deepest ray.
struct Parts {
    sum: fn(Color, Color, Color) -> Color,
    direction: fn(&Ray, &Hit) -> Vector3,
    miss: fn(&ShadowedWorld, bool) -> Color,
    last: u32,
}

const RIGHT: Parts = Parts {
    sum: |own, share, mirrored| own + share * mirrored,
    direction: |ray, hit| (-ray.direction()).reflected_on(hit.normal),
    miss: |world, _| world.objects().background(),
    last: 0,
};

fn trace(parts: &Parts, world: &ShadowedWorld, ray: &Ray, depth: u32, is_first: bool) -> Color {
    if depth <= parts.last {
        return Color::BLACK;
    }
    let Some((hit, surface)) = world.objects().hit(ray, Interval::AHEAD) else {
        return (parts.miss)(world, is_first);
    };
    let own = surface.color_for(ray, &hit, &RecursiveTracer::new(world));
    let next = secondary_ray(ray, &hit, (parts.direction)(ray, &hit));
    let mirrored = trace(parts, world, &next, depth - 1, false);
    (parts.sum)(own, surface.reflection(), mirrored)
}

fn check(check: &mut Check, parts: &Parts) {
    mirror::check(check, |world, ray, depth| {
        trace(parts, world, ray, depth, true)
    });
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "one surface too few",
        says: "one mirror, depth 1",
        check: |c| check(c, &Parts { last: 1, ..RIGHT }),
    },
    Wrong {
        mistake: "a reflected ray that hits nothing is black",
        says: "one mirror, depth 2",
        check: |c| {
            let miss = |world: &ShadowedWorld, first| {
                if first {
                    world.objects().background()
                } else {
                    Color::BLACK
                }
            };
            check(c, &Parts { miss, ..RIGHT });
        },
    },
    Wrong {
        mistake: "the reflectance is left out",
        says: "one mirror, depth 2",
        check: |c| {
            check(
                c,
                &Parts {
                    sum: |own, _, mirrored| own + mirrored,
                    ..RIGHT
                },
            );
        },
    },
    Wrong {
        mistake: "the mirrored light without the own colour",
        says: "one mirror, depth 1",
        check: |c| {
            check(
                c,
                &Parts {
                    sum: |_, share, mirrored| share * mirrored,
                    ..RIGHT
                },
            );
        },
    },
    Wrong {
        mistake: "the ray goes back where it came from",
        says: "a wall in a mirror",
        check: |c| {
            check(
                c,
                &Parts {
                    direction: |ray, _| -ray.direction(),
                    ..RIGHT
                },
            );
        },
    },
];
