//! Triangles anywhere, compared with the solution.

use crate::prelude::*;

yours! { Triangle => new_shape(|[a, b, c]: [_; 3]| Triangle::new(point(a), point(b), point(c))) }

/// Makes a triangle by its corners.
type Code = NewShape<[[f64; 3]; 3]>;
type Other = Variant<Code>;

const TINY: f64 = 1.0 / 1_073_741_824.0;

pub fn exercise() -> Exercise<Code> {
    let corners = [[-0.5, 0.5, -3.0], [0.5, 0.5, -3.0], [0.5, -0.5, -3.0]];
    Exercise {
        picture: scene("scene-4", scene_4, corners),
        wrong: vec![
            Other::new(
                "edges belong to the triangle",
                moeller_trumbore(|b, g| b > 0.0 && g > 0.0 && b + g < 1.0, 0.0),
            ),
            Other::new(
                "beyond the edge from b to c the sum is more than 1",
                moeller_trumbore(
                    |b, g| (0.0..=1.0).contains(&b) && (0.0..=1.0).contains(&g),
                    0.0,
                ),
            ),
            Other::new(
                "the determinant is as small as the direction and the triangle",
                moeller_trumbore(|b, g| b >= 0.0 && g >= 0.0 && b + g <= 1.0, f64::EPSILON),
            ),
        ],
        ..shapes(Shapes {
            words: "triangle {}",
            first: [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [0.0, 2.0, 1.0]],
            further: vec![
                [[-TINY, -TINY, 0.0], [TINY, -TINY, 0.0], [0.0, TINY, 0.0]],
                // In the planes of two axes, and beside them.
                [[0.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]],
                [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0]],
                [[1.0, -2.0, -2.0], [1.0, 0.0, 2.0], [1.0, 2.0, -2.0]],
                [[-2.0, -1.0, -2.0], [2.0, -1.0, -2.0], [0.0, -1.0, 2.0]],
            ],
            on_surface: vec![[0.5, 0.5, 1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0]],
            own_rays: vec![],
            middle: |[a, b, c]| [0, 1, 2].map(|k| (a[k] + b[k] + c[k]) / 3.0),
            any: |r| [(); 3].map(|()| r.triple(5.0)),
        })
    }
}

/// The test of Möller and Trumbore, which accepts two coordinates, and no determinant below this
/// one.
fn moeller_trumbore(is_inside: fn(f64, f64) -> bool, least_determinant: f64) -> Code {
    new_shape(move |corners: [[f64; 3]; 3]| {
        let [a, b, c] = corners.map(point);
        Ok(own(move |ray: &Ray, within: Interval| {
            let (ab, ac) = (b - a, c - a);
            let (d, ao) = (ray.direction(), ray.origin() - a);
            let (p, q) = (d.cross(ac), ao.cross(ab));
            let determinant = ab.dot(p);
            if determinant.abs() < least_determinant {
                return None;
            }
            let (beta, gamma) = (ao.dot(p) / determinant, d.dot(q) / determinant);
            let t = ac.dot(q) / determinant;
            let normal = ab.cross(ac).normalized()?.as_normal();
            (is_inside(beta, gamma) && within.contains(t)).then(|| Hit::new(t, normal))
        }))
    })
}
