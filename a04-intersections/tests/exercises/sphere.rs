//! Spheres anywhere, compared with the solution.

use crate::prelude::*;

yours! { Sphere => new_shape(|(c, r)| Sphere::new(point(c), r)) }

type Code = NewShape<([f64; 3], f64)>;
type Other = Variant<Code>;

/// The radius of a sphere that an epsilon would swallow.
const TINY: f64 = 1.0 / 1_073_741_824.0;

pub fn exercise() -> Exercise<Code> {
    Exercise {
        picture: scene("scene-2", scene_2, ([0.0, 0.0, -3.0], 0.5)),
        wrong: vec![
            Other::new(
                "from inside, only the far root is ahead",
                textbook(both_roots, |[near, _], within| {
                    Some(near).filter(|t| within.contains(*t))
                }),
            ),
            Other::new(
                "a ray that touches hits: no root is below 0",
                textbook(both_roots, |roots, within| {
                    first(roots, within).filter(|_| roots[0] < roots[1])
                }),
            ),
            Other::new(
                "the quotient is of the whole sum, which needs parentheses",
                textbook(|a, b, root| [-b - root / a, -b + root / a], first),
            ),
            Other::new(
                "the quotient is by the whole product, which needs parentheses",
                textbook(|a, b, root| [(-b - root) * a, (-b + root) * a], first),
            ),
        ],
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

/// The roots of a quadratic equation: by its `a`, its `b`, and the root of its discriminant.
type Roots = fn(f64, f64, f64) -> [f64; 2];

fn both_roots(a: f64, b: f64, root: f64) -> [f64; 2] {
    [(-b - root) / a, (-b + root) / a]
}

/// The textbook's `a t² + 2 b t + k = 0`, with a choice among its roots.
fn textbook(roots: Roots, choose: fn([f64; 2], Interval) -> Option<f64>) -> Code {
    new_shape(move |(c, r): (_, f64)| {
        let c = point(c);
        Ok(own(move |ray: &Ray, within| {
            let (f, d) = (ray.origin() - c, ray.direction());
            let (a, b) = (d.dot(d), f.dot(d));
            let root = (b * b - a * (f.dot(f) - r * r)).sqrt();
            let t = choose(roots(a, b, root), within)?;
            Some(Hit::new(t, ((ray.at(t) - c) * (1.0 / r)).as_normal()))
        }))
    })
}

fn first(roots: [f64; 2], within: Interval) -> Option<f64> {
    roots.into_iter().find(|t| within.contains(*t))
}
