//! Directions around poles, compared with the solution.

use crate::prelude::*;

pub fn check(check: &mut Check, yours: fn(Vector3, Vector3, f64) -> u32) {
    check.exactly("loses the digits of small angles");
    let up = [0.0, 1.0, 0.0];
    let directions = [up, [0.0, 2.0, 0.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]];
    check.compare(
        "direction {}, pole {}, rings of width {}",
        directions.map(|direction| (direction, up, 0.75)),
        random(|r| {
            let (pole, aside, length) = (r.triple(2.0), r.triple(9.0), r.between(0.1, 9.0));
            let width = [1.0, 0.1, 1e-3, 1e-9][r.below(4) as usize];
            let direction = [0, 1, 2].map(|k| length * (pole[k] + width * aside[k]));
            (direction, pole, width)
        }),
        [ring, yours],
        |ring, (direction, pole, width)| ring(vector(direction), vector(pole), width),
    );
    check.picture(|settings| {
        let [pole, gaze, up] = [[0.3, 0.4, -1.0], [0.0, 0.0, -1.0], up].map(vector);
        let camera = PerspectiveCamera::new(Point3::ORIGIN, gaze, up, FRAC_PI_3)?;
        let paint = |ray: &Ray| match yours(ray.direction(), pole, 0.1) % 2 {
            0 => Color::from_bytes([25, 25, 112]),
            _ => Color::from_bytes([50, 205, 50]),
        };
        render(&camera, paint, settings, &())
    });
}

variants! { check:
    yours => ring;
    wrong "an arc cosine near 1 has few digits" => |d, pole, width| {
        let cosine = d.dot(pole) / (d.magnitude() * pole.magnitude());
        (libm::acos(cosine.clamp(-1.0, 1.0)) / width) as u32
    };
    wrong "rings are behind the pole, too" => |d, pole, width| {
        (d.angle(pole).min(d.angle(-pole)) / width) as u32
    };
    wrong "a number of a ring is rounded down" => |d, pole, width| {
        (d.angle(pole) / width).round() as u32
    };
}
