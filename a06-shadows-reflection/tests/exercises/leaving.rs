//! Rays that leave shapes of all sizes, near the origin and far away, steep and grazing, to
//! both sides, compared with the solution.

use crate::departure::{Departure, Numbers, SHAPES};
use crate::prelude::*;

yours! { secondary_ray }

type Code = fn(&Ray, &Hit, Vector3) -> Ray;
type Other = Variant<Code>;

pub fn exercise() -> Exercise<Code> {
    let (up, down) = ([0.8, 0.6, 0.0], [0.8, -0.6, 0.0]);
    let mut simple = Vec::new();
    for (direction, size) in [(up, 1.0), (down, 1.0), (up, 1e-9)] {
        for shape in SHAPES {
            simple.push(Departure {
                shape,
                normal: [0.0, 1.0, 0.0],
                size,
                point: [0.0; 3],
                to_eye: [0.0, 2.0, 1.0],
                direction,
            });
        }
    }
    let mut others = random(Departure::any);
    others.extend(random(Departure::grazing));
    let departures = Questions {
        words: "{} with normal {}, of size {}, at {} sizes, the eye {} sizes away, left along {}",
        simple,
        others,
        answer: |secondary_ray: &Code, departure: Departure| departure.answer(secondary_ray),
    };
    Exercise {
        questions: departures.into(),
        picture: Picture::scene("sphere", |leaving: &Code, settings| {
            traced_picture(scenes::sphere()?, settings, |world, ray, depth| {
                let tracer = Tracer {
                    world,
                    is_shadowed: &is_shadowed,
                    secondary_ray: leaving,
                };
                tracer.trace(ray, depth)
            })
        }),
        wrong: vec![
            Other::new("no length is fixed", |ray, hit, direction| {
                offset(ray, hit, direction, hit.geometric_normal.into(), 1e-9)
            }),
            Other::new(
                "the errors of the coordinates count, too",
                |ray, hit, direction| {
                    let length = 1e-12 * hit.t;
                    offset(ray, hit, direction, hit.geometric_normal.into(), length)
                },
            ),
            Other::new("the error of t counts, too", |ray, hit, direction| {
                let length = 1e-12 * Numbers::of(ray, hit).point;
                offset(ray, hit, direction, hit.geometric_normal.into(), length)
            }),
            Other::new(
                "a grazing ray does not leave along itself",
                |ray, hit, direction| offset(ray, hit, direction, direction, largest(ray, hit)),
            ),
            Other::new(
                "along itself, a grazing ray would have to go far",
                |ray, hit, direction| {
                    let length = 1e-12 * Numbers::of(ray, hit).sum();
                    offset(ray, hit, direction, direction, length)
                },
            ),
            Other::new(
                "the face says where the surface is",
                |ray, hit, direction| {
                    offset(ray, hit, direction, hit.normal.into(), largest(ray, hit))
                },
            ),
        ],
        ..Exercise::default()
    }
}

/// The ray that is offset along this vector by this length.
fn offset(ray: &Ray, hit: &Hit, direction: Vector3, along: Vector3, length: f64) -> Ray {
    let length = length.copysign(along.dot(direction));
    Ray::derived(ray.at(hit.t) + along * length, direction)
}

fn largest(ray: &Ray, hit: &Hit) -> f64 {
    let at = Numbers::of(ray, hit);
    1e-14 * at.origin.max(at.point).max(at.t)
}
