//! Spheres anywhere, compared with the solution.

use crate::prelude::*;

yours! { Sphere => new_shape(|(c, r)| Sphere::new(point(c), r)) }

type Code = NewShape<([f64; 3], f64)>;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-2", scene_2, ([0.0, 0.0, -3.0], 0.5)),
        ..shapes(Shapes {
            words: "sphere around {} of radius {}",
            first: ([0.0, 0.0, 0.0], 1.0),
            further: vec![([1.0, 0.0, 0.5], 2.0)],
            on_surface: vec![[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]],
            own_rays: [of_sizes(|size| ([0.0; 3], size)), beside_outline()].concat(),
            middle: |(c, _)| *c,
            any: |r| (r.triple(5.0), r.between(0.2, 4.0)),
        })
    }
}

/// Rays close to the outline of the first sphere. Just inside, rounding moves the hits of right formulas.
fn beside_outline() -> Vec<(([f64; 3], f64), RayWithin)> {
    let outline = [
        ([1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]),
        ([0.0, 0.0, -1.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]),
    ];
    let mut rays = beside(&([0.0, 0.0, 0.0], 1.0), &outline);
    rays.retain(|(_, ([x, _, z], ..))| x.max(-z) > 1.0 || x.max(-z) < 1.0 - 1e-9);
    rays
}
