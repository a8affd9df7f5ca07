//! Points on triangles that stand for bulges and for hollows, compared with the solution.

use crate::prelude::*;

yours! { shadow_start }

/// The start of the shadow rays, by the corners, their normals, and the weights of the point.
type Code = fn(Corners, [Normal3; 3], [f64; 3]) -> Point3;

/// The corners of a triangle.
type Corners = [Point3; 3];

pub fn exercise() -> Exercise<Code> {
    let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, -4.0]];
    let (left, up, right) = ([-0.6, 0.8, 0.0], [0.0, 1.0, 0.0], [0.6, 0.8, 0.0]);
    let half = [0.5, 0.5, 0.0];
    let points = Questions {
        words: "corners {}, their normals {}, weights {}",
        simple: vec![
            // On a flat triangle, in a corner and on an edge of a bulge, in a hollow, and where
            // only one corner is bent.
            (corners, [up; 3], [0.5, 0.25, 0.25]),
            (corners, [left, right, up], [1.0, 0.0, 0.0]),
            (corners, [left, right, up], half),
            (corners, [right, left, up], half),
            (corners, [left, up, up], half),
        ],
        others: random(any),
        answer: |shadow_start: &Code, (corners, normals, weights): ([_; 3], [_; 3], _)| {
            let normals = normals.map(|normal| unit(normal).as_normal());
            array(shadow_start(corners.map(point), normals, weights))
        },
    };
    Exercise {
        questions: points.into(),
        ..Exercise::default()
    }
}

fn any(r: &mut Random) -> ([[f64; 3]; 3], [[f64; 3]; 3], [f64; 3]) {
    let size = r.scale();
    let corners = [(); 3].map(|()| r.triple(1.0).map(|x| x * size));
    let axis = r.triple(1.0);
    let normals = [(); 3].map(|()| array(unit(array(unit(axis) + vector(r.triple(0.4))))));
    let beta = r.between(0.0, 1.0);
    let gamma = (1.0 - beta) * r.between(0.0, 1.0);
    (corners, normals, [1.0 - beta - gamma, beta, gamma])
}
