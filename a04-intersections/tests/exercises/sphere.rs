//! Spheres anywhere, compared with the solution.

use crate::prelude::*;

yours! { Sphere => new_shape(|(c, r)| Sphere::new(point(c), r)) }

type Code = NewShape<([f64; 3], f64)>;

/// The radius of a sphere that an epsilon would swallow.
const TINY: f64 = 1.0 / 1_073_741_824.0;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-2", scene_2, ([0.0, 0.0, -3.0], 0.5)),
        ..shapes(Shapes {
            words: "sphere around {} of radius {}",
            first: ([0.0, 0.0, 0.0], 1.0),
            further: vec![([1.0, 0.0, 0.5], 2.0)],
            on_surface: vec![[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]],
            own_rays: scaled(TINY)
                .into_iter()
                .map(|ray| (([0.0; 3], TINY), ray))
                .collect(),
            middle: |(c, _)| *c,
            any: |r| (r.triple(5.0), r.between(0.2, 4.0)),
        })
    }
}
