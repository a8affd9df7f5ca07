//! Rays that leave shapes of all sizes, near the origin and far away, steep and grazing, to
//! both sides, compared with the solution.

use crate::departure::{Departure, SHAPES};
use crate::prelude::*;

yours! { secondary_ray }

type Code = fn(&Ray, &Hit, Vector3) -> Ray;

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
        ..Exercise::default()
    }
}
