//! Directions around poles, compared with the solution.

use crate::prelude::*;

yours! { ring }

type Code = fn(Vector3, Vector3, f64) -> u32;

pub fn exercise() -> Exercise<Code> {
    let up = [0.0, 1.0, 0.0];
    let directions = Questions {
        words: "direction {}, pole {}, rings of width {}",
        simple: vec![
            (up, up, 0.75),
            ([0.0, 2.0, 0.0], up, 0.75),
            ([1.0, 0.0, 0.0], up, 0.75),
            ([0.0, -1.0, 0.0], up, 0.75),
            ([0.0, -1.0, 0.0], [0.0, -3.0, 0.0], 0.75),
            ([0.0, -2.0, 1.0], up, 0.75),
            ([1.0, -1.0, 0.0], up, 0.5),
            ([1.0, 0.0, 0.0], up, 1e-3),
            ([1.0, 0.0, 0.0], up, 1e-6),
            ([3e-9, 2.0, 0.0], up, 1e-9),
        ],
        others: random(|r| {
            let (pole, aside, length) = (r.triple(2.0), r.triple(9.0), r.between(0.1, 9.0));
            let width = [1.0, 0.1, 1e-3, 1e-9][r.below(4) as usize];
            let direction = [0, 1, 2].map(|k| length * (pole[k] + width * aside[k]));
            (direction, pole, width)
        }),
        answer: |ring: &Code, (direction, pole, width)| {
            ring(vector(direction), vector(pole), width)
        },
    };
    Exercise {
        questions: directions.into(),
        picture: Picture::own(|ring: &Code, settings| sky_of_rings(*ring, settings)),
        ..Exercise::default()
    }
}

fn sky_of_rings(ring: Code, settings: &Settings) -> Result<Image, Error> {
    let pole = Vector3::new(0.3, 0.4, -1.0);
    let (gaze, up) = (Vector3::new(0.0, 0.0, -1.0), Vector3::new(0.0, 1.0, 0.0));
    let camera = PerspectiveCamera::new(Point3::ORIGIN, gaze, up, FRAC_PI_3)?;
    let radiance = |ray: &Ray| match ring(ray.direction(), pole, 0.1) % 2 {
        0 => Color::from_bytes([25, 25, 112]),
        _ => Color::from_bytes([50, 205, 50]),
    };
    render(&camera, radiance, settings, &())
}
