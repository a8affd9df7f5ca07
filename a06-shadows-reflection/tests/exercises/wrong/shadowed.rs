//! Wrong solutions: another ray, or another interval.

use a03_rays_cameras::Ray;
use a04_intersections::{Hit, Interval};
use a05_lighting::Illumination;
use a06_shadows_reflection::secondary_ray;
use testing::exercise::{Check, Wrong};

use crate::shadowed;

fn check(
    check: &mut Check,
    to_light: fn(&Ray, &Hit, &Illumination) -> Ray,
    within: fn(&Illumination) -> Interval,
) {
    shadowed::check(check, |world, ray, hit, light| {
        world.is_hit(&to_light(ray, hit, light), within(light))
    });
}

fn leaving(ray: &Ray, hit: &Hit, light: &Illumination) -> Ray {
    secondary_ray(ray, hit, light.direction)
}

fn before(light: &Illumination) -> Interval {
    Interval::before(light.distance * (1.0 - 1e-7))
}

pub const WRONG: &[Wrong] = &[
    Wrong {
        mistake: "objects beyond the light cast shadows",
        says: "shadow, a ball beyond the light",
        check: |c| check(c, leaving, |_| Interval::AHEAD),
    },
    Wrong {
        mistake: "away from the light",
        says: "shadow, a ball half way to the light",
        check: |c| {
            check(
                c,
                |ray, hit, light| secondary_ray(ray, hit, -light.direction),
                before,
            );
        },
    },
    Wrong {
        mistake: "the lamp's ceiling blocks its light",
        says: "shadow, the ceiling",
        check: |c| {
            check(c, leaving, |light| {
                Interval::before(light.distance * (1.0 + 1e-9))
            });
        },
    },
    Wrong {
        mistake: "only objects beyond the light",
        says: "shadow, a ball half way to the light",
        check: |c| {
            check(c, leaving, |light| Interval {
                min: light.distance,
                max: f64::INFINITY,
            });
        },
    },
    Wrong {
        mistake: "the surface shadows itself",
        says: "shadow, nothing but the surface itself",
        check: |c| {
            check(
                c,
                |ray, hit, light| {
                    let below = ray.at(hit.t + 1e-9 * hit.t);
                    Ray::derived(below, light.direction)
                },
                before,
            );
        },
    },
];
