//! Planes anywhere, compared with the solution.

use crate::prelude::*;

yours! { Plane => new_shape(|(a, n)| Plane::new(point(a), vector(n).as_normal())) }

/// Makes a plane by a point and a normal.
type Code = NewShape<([f64; 3], [f64; 3])>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-1", scene_1, ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0])),
        ..shapes(Shapes {
            words: "plane through {}, normal {}",
            first: ([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]),
            further: vec![
                ([1.0, 0.0, 0.0], [-2.0, 0.0, 0.0]),
                ([0.0, 0.0, -1.0], [0.0, 0.0, 1.0]),
            ],
            on_surface: vec![[0.0, 1.0, 0.0], [3.0, 1.0, -4.0]],
            own_rays: [
                of_sizes(|size| ([0.0, size, 0.0], [0.0, 1.0, 0.0])),
                almost_parallel(),
            ]
            .concat(),
            middle: |(a, _)| *a,
            any: |r| (r.triple(5.0), r.triple(5.0)),
        })
    }
}

/// Rays that are almost parallel to the first plane, down to it and away from it.
fn almost_parallel() -> Vec<(([f64; 3], [f64; 3]), RayWithin)> {
    let mut rays = Vec::new();
    for slope in [-1e-3, -1e-6, -1e-12, 1e-12] {
        let ray = ahead([0.5, 3.0, 0.25], [1.0, slope, 0.0]);
        rays.push((([0.0, 1.0, 0.0], [0.0, 1.0, 0.0]), ray));
    }
    rays
}
